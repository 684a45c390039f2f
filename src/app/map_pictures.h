// Radiance maps as pictures of N x N pixels, one for each texel, in linear values in [0, 1] that writePng encodes.
#pragma once
#include <span>
#include <vector>

#include "image/image.h"
#include "maps/map_capture.h"

namespace drc {

// radiance: [3][N*N], by channel and texel. It is multiplied by the exposure; values above 1 are clipped.
Image radiancePicture(std::span<const float> radiance, const MapLayout& layout, float exposure);

// Grey, logarithmic, from the nearest (dark) to the farthest texel (white); blue where a ray escaped.
Image distancePicture(const CapturedMap& map, const MapLayout& layout);

// The components x, y, z in the map's frame as red, green, blue: -1 to 1 as 0 to 255; black where a ray escaped.
Image normalPicture(const CapturedMap& map, const MapLayout& layout);

// For each texel, the mean absolute difference of the three channels, divided by `unit`. With the target's mean as the
// unit, the mean of this over the hemisphere is MapScores::l1.
std::vector<float> texelErrors(std::span<const float> radiance, std::span<const float> target, float unit);

// Errors in false colour: black at zero, through violet and orange to pale yellow at `white` and above.
Image errorPicture(std::span<const float> errors, const MapLayout& layout, float white);
// The colours of errorPicture from zero to `white`, as 256 x 1 pixels.
Image errorScale();

}  // namespace drc
