// A frame of an animation as filters over time see it: noisy light in two halves, and the surfaces that it shows.
#pragma once
#include <array>

#include "image/frame_surfaces.h"

namespace drc {

// Light in two halves with independent samples, whose mean is the picture: R, G, B.
using LightHalves = std::array<Image, 2>;

struct TemporalFrame {
    FrameSurfaces surfaces;
    LightHalves direct;    // light straight from emitters, or all light where `indirect` is empty
    LightHalves indirect;  // all other light; empty images if the file has no halves of direct light
    bool hasParts() const { return !indirect[0].empty(); }
};

// Reads the layers that drc render --aovs writes. Throws Error, naming the file, if one that is needed is missing.
TemporalFrame temporalFrameOf(const PictureFile& picture);

}  // namespace drc
