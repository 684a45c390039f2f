// The format of a picture's file, determined by its first bytes and not by its name, because many files have the
// extension of another format.
#pragma once
#include <string_view>

namespace drc {

enum class ImageFormat { Unknown, Exr, Png, Jpeg, Tiff, RadianceHdr, Tga, Pfm };

// The formats that can be read, for messages.
inline constexpr std::string_view kFormatsRead = "EXR, PNG, JPEG, TIFF, TGA, Radiance HDR and PFM files are read";

// TGA has no signature at its start. A file is a TGA by the signature at its end, which version 2 of the format has, or
// by its name, unless its header is invalid and the file is plainly of another format.
ImageFormat imageFormatOf(std::string_view bytes, std::string_view path);

// The name of a format that is known but cannot be read, as "GIF" or "WebP"; empty if it is none of these.
std::string_view foreignFormatOf(std::string_view bytes);

}  // namespace drc
