// EXR metadata on the picture's placement and storage.
#pragma once
#include <map>
#include <set>
#include <string>

namespace drc {

// Where a picture's pixels (OpenEXR's data window) lie within the whole picture (its display window), in pixels. A part
// of a picture lies inside of it; with overscan the pixels reach beyond it. A size of 0: the pixels are the whole
// picture, as in formats that have no windows.
struct ExrWindow {
    int x = 0, y = 0;  // of the first pixel, from the upper left corner of the whole
    int fullWidth = 0, fullHeight = 0;
    int displayX = 0, displayY = 0;  // where the file puts that corner; no position depends on it

    bool operator==(const ExrWindow&) const = default;
};

// String attributes.
using ExrMetadata = std::map<std::string, std::string>;

// An attribute of another type, in the bytes of the file.
struct ExrAttribute {
    std::string type, value;
};
using ExrAttributes = std::map<std::string, ExrAttribute>;

// Channels are stored as 32-bit floats unless they are named here.
struct ExrStorage {
    std::set<std::string> halfChannels;     // 16 bits: finite values beyond 65504 are clamped to it
    std::set<std::string> integerChannels;  // 32 bits, unsigned; floats if a value is no such integer
    int compression = 3;                    // OpenEXR's number of it: 3 is ZIP
    // The pixel aspect ratio, time codes, matrices of the camera and the like: all but strings, and but those that
    // describe the layout of the file or the primaries of its colours.
    ExrAttributes attributes;
};

}  // namespace drc
