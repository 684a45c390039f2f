// EXR files whose colours have other primaries than Rec. 709, such as those of ACES or Rec. 2020.
#pragma once
#include <optional>

#include "image/exr_storage.h"
#include "image/image.h"
#include "image/white_balance.h"

namespace drc {

// The matrix from linear RGB with the primaries and white of an attribute of the type chromaticities to linear Rec.
// 709: through XYZ, with the white adapted to D65 in Bradford's space, so that (1, 1, 1) stays (1, 1, 1). Empty if the
// chromaticities are those of Rec. 709, to four digits. Throws Error if they are not valid primaries and a white.
// Source: "RGB Color", in the technical introduction to OpenEXR.
std::optional<RgbMatrix> rec709From(const ExrAttribute& chromaticities);

// Whether a layer with channels R, G and B contains data instead of colours, judging by its name: normals, positions,
// motion, depths, identifiers (Cryptomatte) or variances.
bool isDataLayer(const std::string& layer);

// Applies the matrix to the channels R, G and B of a layer if the image has all three.
void mapColours(Image& image, const std::string& layer, const RgbMatrix& map);

}  // namespace drc
