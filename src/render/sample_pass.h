// Passes of camera samples over the film. The first sample of the pixels is taken in three passes, over every fourth
// row and column, then every second, then the rest, so that there is soon a whole picture, if a coarse one; each
// further pass takes one sample of every pixel.
#pragma once
#include <algorithm>
#include <cstdint>

#include "image/image.h"
#include "render/film_layer.h"

namespace drc {

struct SamplePass {
    static constexpr int kLattices = 3;

    int pass = 0;  // from 0

    // Which sample of its pixels the pass takes.
    uint32_t sample() const { return uint32_t(std::max(0, pass - (kLattices - 1))); }
    // Samples that every pixel has had after so many passes.
    static int wholeSamples(int passes) { return std::max(0, passes - (kLattices - 1)); }
    static int passesFor(int samples) { return samples > 0 ? samples + kLattices - 1 : 0; }
    // Whether the pass ends a sample of every pixel.
    bool endsSample() const { return pass >= kLattices - 1; }

    // Calls f(column) for the columns of the region that the pass samples in a row of it.
    template <class F>
    void forEachColumn(int row, int width, F&& f) const {
        const int step = pass == 0 ? 4 : pass == 1 ? 2 : 1;
        if (row % step != 0) return;
        // What the lattice before has sampled already.
        const bool shared = pass > 0 && pass < kLattices && row % (2 * step) == 0;
        for (int column = shared ? step : 0; column < width; column += shared ? 2 * step : step) f(column);
    }
};

// Gives pixels that have no sample yet, while the first lattices are under way, the value of the nearest sample up and
// left on a coarser lattice. sampled: a layer that every camera sample adds to, of the image's region.
void fillUnsampled(Image& image, const FilmLayer& sampled);

}  // namespace drc
