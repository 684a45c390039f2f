// EXR metadata on the picture's placement and storage.
#pragma once
#include <map>
#include <set>
#include <string>

namespace drc {

// The place of the stored pixels (OpenEXR's data window) within the whole picture (the display window), in pixels. The
// stored pixels may be a part of the whole or, with overscan, extend beyond it. fullWidth = fullHeight = 0: the stored
// pixels are the whole picture, as in formats without windows.
struct ExrWindow {
    int x = 0, y = 0;  // of the first stored pixel, relative to the upper left corner of the whole
    int fullWidth = 0, fullHeight = 0;
    int displayX = 0, displayY = 0;  // the file's coordinates of this corner; x and y do not depend on them

    bool operator==(const ExrWindow&) const = default;
};

// String attributes.
using ExrMetadata = std::map<std::string, std::string>;

// An attribute of any type: the name of the type, and the value as bytes of the file.
struct ExrAttribute {
    std::string type, value;
};
using ExrAttributes = std::map<std::string, ExrAttribute>;

// Channels are stored as 32-bit floats unless they are named here.
struct ExrStorage {
    std::set<std::string> halfChannels;     // 16 bits: finite values beyond 65504 are clamped to it
    std::set<std::string> integerChannels;  // 32-bit unsigned; stored as floats if a value is no such integer
    int compression = 3;                    // OpenEXR's number of the method; 3 is ZIP
    // The pixel aspect ratio, time codes, camera matrices and the like: all attributes except strings and those that
    // describe the layout of the file or the primaries of its colours.
    ExrAttributes attributes;
};

}  // namespace drc
