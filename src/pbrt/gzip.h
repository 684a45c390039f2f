// Decompresses the files that pbrt-v4 allows to be gzipped: meshes (.ply.gz) and scenes (.pbrt.gz).
#pragma once
#include <string>
#include <string_view>

#include "base/limits.h"

namespace drc::pbrt {

// Checks the first two bytes, whatever the file name.
bool isGzip(std::string_view bytes);

// Maximum size after decompression: the larger of the two limits. Larger files are damaged or malicious.
struct GunzipLimit {
    size_t bytes = limits::kGunzipBytes;
    size_t ratio = limits::kGunzipRatio;  // relative to the compressed size
};
// Throws Error "path: ..." for a stream that is damaged, truncated or beyond the limit.
std::string gunzip(std::string_view bytes, const std::string& path, const GunzipLimit& limit = {});

}  // namespace drc::pbrt
