// pbrt-v4's images of the sphere of directions: squares in which every pixel has the same solid angle (Clarberg 2008;
// PBR 4e, section 3.8.3). The upper hemisphere is the inner diamond of the square, with +z at its centre.
#pragma once
#include "scene/lights/light_image.h"

namespace drc::pbrt {

// The position in the unit square of a direction of any non-zero length. u grows towards +x, v towards +y.
Vec2 equalAreaSquareOf(const Vec3& direction);
Vec3 equalAreaDirectionOf(const Vec2& uv);

// Converts the image to the lat-long layout of scene/light.h: u = phi / 2 pi, v = theta / pi from +z. It is twice as
// wide as the square and as high, with the same total energy in each channel. Empty for an empty image.
LightImage latLongFromEqualArea(const LightImage& square);

// Illuminance of a horizontal surface by the image's upper hemisphere.
double horizontalIlluminance(const LightImage& square);

LightImage flippedTopToBottom(LightImage image);

}  // namespace drc::pbrt
