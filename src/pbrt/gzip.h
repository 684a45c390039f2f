// Files that pbrt-v4 lets be compressed: meshes (.ply.gz) and scenes (.pbrt.gz).
#pragma once
#include <string>
#include <string_view>

#include "base/limits.h"

namespace drc::pbrt {

// By the first two bytes, whatever the file's name.
bool isGzip(std::string_view bytes);

// What a file may grow to: the larger of the two. What promises far more is damaged, or made to fill the memory.
struct GunzipLimit {
    size_t bytes = limits::kGunzipBytes;
    size_t ratio = limits::kGunzipRatio;  // to the compressed size
};
// Throws Error "path: ..." for a stream that is damaged, cut short, or beyond the limit.
std::string gunzip(std::string_view bytes, const std::string& path, const GunzipLimit& limit = {});

}  // namespace drc::pbrt
