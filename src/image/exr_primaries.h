// EXR files whose colours are not of Rec. 709's primaries, such as those of ACES or Rec. 2020.
#pragma once
#include <optional>

#include "image/exr_storage.h"
#include "image/image.h"
#include "image/white_balance.h"

namespace drc {

// The map from linear colours of the primaries and the white that an attribute of the type chromaticities gives to
// linear Rec. 709: by way of XYZ, with the white adapted to D65 in Bradford's space, so that (1, 1, 1) stays (1, 1, 1).
// Nothing if they are Rec. 709's, to four digits. Throws Error if they are no primaries or no white. Source: "RGB
// Color", in the technical introduction to OpenEXR.
std::optional<RgbMatrix> rec709From(const ExrAttribute& chromaticities);

// Whether a layer with channels R, G and B has no colours: its name is that of normals, positions, motion, depths,
// identifiers (Cryptomatte) or variances.
bool isDataLayer(const std::string& layer);

// Maps the channels R, G and B of a layer if the image has them all.
void mapColours(Image& image, const std::string& layer, const RgbMatrix& map);

}  // namespace drc
