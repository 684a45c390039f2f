// pbrt-v4's pictures of the sphere of directions: squares whose every pixel has the same solid angle (Clarberg 2008;
// PBR 4e, section 3.8.3). The upper half of the sphere is the square's inner diamond, +z its centre.
#pragma once
#include "scene/light_image.h"

namespace drc::pbrt {

// Where in the unit square a direction (of any length but zero) is. u grows towards +x, v towards +y.
Vec2 equalAreaSquareOf(const Vec3& direction);
Vec3 equalAreaDirectionOf(const Vec2& uv);

// The same picture by longitude and latitude as the lights of scene/light.h take it: u = phi / 2 pi, v = theta / pi
// from +z. Twice as wide as the square, as high, and in all as bright, channel by channel. Empty for an empty picture.
LightImage latLongFromEqualArea(const LightImage& square);

// What a horizontal surface under the picture's upper half is lit with.
double horizontalIlluminance(const LightImage& square);

LightImage flippedTopToBottom(LightImage image);

}  // namespace drc::pbrt
