// A ray in world space, with its ray cone.
#pragma once
#include "math/vec.h"

namespace drc {

struct Medium;

struct Ray {
    Vec3 o;
    Vec3 d;                  // unit, unless stated otherwise
    float tMax = kInfinity;  // in units of the length of d
    float time = 0;          // in [0, 1], as a share of the motion interval (see Shutter); constant along a path
    // Ray cone for texture filtering (Akenine-Moeller et al., "Texture Level of Detail Strategies for Real-Time Ray
    // Tracing", 2019): the cone's width at o in world units, and the growth of the width per unit of distance.
    float coneWidth = 0;
    float coneSpread = 0;
    const Medium* medium = nullptr;  // the medium at o; null: empty space
    // Whether the path has not been scattered since it left the camera. Such rays pass through surfaces and miss lights
    // that are hidden from the camera (Primitive::visibleToCamera, Light::visibleToCamera).
    bool fromCamera = false;
    // Whether the last scattering of a path from the camera was specular (a mirror or smooth glass). Rays with neither
    // flag pass through surfaces that are hidden from diffuse rays (Primitive::visibleToDiffuse).
    bool mirrored = false;
};

}  // namespace drc
