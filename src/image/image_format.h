// What kind of file a picture is, told by its first bytes and not by its name: files are often called what they once
// were.
#pragma once
#include <string_view>

namespace drc {

enum class ImageFormat { Unknown, Exr, Png, Jpeg, RadianceHdr, Tga, Pfm };

// Those that are read, for messages.
inline constexpr std::string_view kFormatsRead = "EXR, PNG, JPEG, TGA, Radiance HDR and PFM files are read";

// TGA has no mark at its start. A file is one by the mark at its end, which its second version has, or by its name,
// unless its header makes no sense and the file is plainly of another kind.
ImageFormat imageFormatOf(std::string_view bytes, std::string_view path);

// "TIFF", "GIF", ...: kinds of pictures that are known and not read. Empty if it is none of them either.
std::string_view foreignFormatOf(std::string_view bytes);

}  // namespace drc
