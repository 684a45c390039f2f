// pbrt-v4's images of the sphere of directions: squares in which every pixel covers the same solid angle (Clarberg
// 2008; PBR 4e, section 3.8.3). The square's inner diamond shows the upper hemisphere, with +z at its centre.
#pragma once
#include "scene/lights/light_image.h"

namespace drc::pbrt {

// The position in the unit square that shows a direction, which may have any non-zero length. u grows towards +x, v
// towards +y.
Vec2 equalAreaSquareOf(const Vec3& direction);
Vec3 equalAreaDirectionOf(const Vec2& uv);

// Converts the image to the lat-long layout of scene/lights/light.h: u = phi / 2 pi, v = theta / pi from +z. The result
// is twice as wide as the square and equally high, with the same total energy in each channel. Empty for an empty
// image.
LightImage latLongFromEqualArea(const LightImage& square);

// Illuminance that the image's upper hemisphere produces on a horizontal surface.
double horizontalIlluminance(const LightImage& square);

LightImage flippedTopToBottom(LightImage image);

}  // namespace drc::pbrt
