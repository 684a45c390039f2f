// Portable float map: "PF" (RGB) or "Pf" (grey), width, height, a scale whose sign gives the byte order (negative:
// little endian), then 32-bit floats, the bottom row first.
#pragma once
#include <string>
#include <string_view>

#include "image/image.h"

namespace drc {

bool isPfm(std::string_view bytes);
// The byte order to assume. Other: the opposite of the named one, because some writers name the wrong one.
enum class PfmOrder { AsNamed, Other };

// Values times |scale|, first row on top. `path` is for messages. Throws Error on a damaged file.
Image decodePfm(std::string_view bytes, const std::string& path, PfmOrder order = PfmOrder::AsNamed);
// Encodes the first channel of an image with fewer than three, else the first three. Little endian.
std::string encodePfm(const Image& image);

}  // namespace drc
