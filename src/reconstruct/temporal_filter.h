// Averages the noisy light of a frame with that of its neighbours in an animation, before it is denoised.
//
// A neighbour's light is taken from where it shows the same points (surface_match.h), times the ratio of both albedos,
// so that textures are not blurred. Light that has changed, such as moving shadows, highlights and reflections, is told
// by a two-sided test: the mean difference of both frames over a small window, in units of its standard error, which
// the halves of both frames give: their differences have the same noise as the frames', but not what has changed.
// Direct and indirect light are tested apart, indirect light over larger windows, because it is smooth and noisy.
#pragma once
#include <span>

#include "reconstruct/temporal_frame.h"

namespace drc {

struct FilteredFrame {
    LightHalves direct, indirect;  // as in TemporalFrame
    Image frames;                  // X: the number of frames, by weight, that a pixel's indirect or whole light has

    // The mean of the halves of all light; may be negative where the pixel filter has negative lobes.
    Image beauty() const;
    Image directLight() const;
    // R, G, B: variance of beauty(), from the difference of its halves.
    Image variance() const;
    // One of the two halves of all light.
    Image half(size_t i) const;
};

// Throws Error, naming both files, if frames differ in size, place or layers.
FilteredFrame filteredOverTime(const TemporalFrame& frame, std::span<const TemporalFrame* const> neighbours);

}  // namespace drc
