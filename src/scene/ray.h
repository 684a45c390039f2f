// A ray in world space, with its ray cone.
#pragma once
#include "math/vec.h"

namespace drc {

struct Medium;

struct Ray {
    Vec3 o;
    Vec3 d;                  // unit, unless stated otherwise
    float tMax = kInfinity;  // in units of the length of d
    float time = 0;          // in [0, 1], as a share of the motion interval (see Shutter); the same for a whole path
    // Ray cone for texture filtering (Akenine-Moeller et al., "Texture Level of Detail Strategies for Real-Time Ray
    // Tracing", 2019): its width at o in world units, and the growth of its width per unit of distance.
    float coneWidth = 0;
    float coneSpread = 0;
    const Medium* medium = nullptr;  // that the ray is in; null: empty space
    // Whether nothing has scattered it since it left the camera: it does not see what Primitive and Light hide from the
    // camera.
    bool fromCamera = false;
    // Whether a mirror or smooth glass has sent it here, on its way from the camera. Neither of the two: it does not
    // see what Primitive hides from diffuse rays.
    bool mirrored = false;
};

}  // namespace drc
