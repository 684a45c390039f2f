// Sample passes: passes of camera samples over the film. The first sample of the pixels is taken in three passes, over
// every fourth row and column, then every second, then the rest, so that there is soon a coarse picture of the whole
// film; each further pass takes one sample of every pixel.
#pragma once
#include <algorithm>
#include <cstdint>
#include <initializer_list>

#include "film/film_layer.h"
#include "image/image.h"

namespace drc {

// The samples that a pass takes of a pixel, by their indices within it.
struct PixelSamples {
    uint32_t first = 0;
    int count = 1;
};

struct SamplePass {
    static constexpr int kLattices = 3;

    int pass = 0;  // from 0

    // The distance of the rows and columns of a lattice.
    static int stepOf(int lattice) { return 4 >> lattice; }

    // The index, within a pixel, of the sample that the pass takes.
    uint32_t sample() const { return uint32_t(std::max(0, pass - (kLattices - 1))); }
    // The number of samples that every pixel has had after so many passes, and its inverse.
    static int wholeSamples(int passes) { return std::max(0, passes - (kLattices - 1)); }
    static int passesFor(int samples) { return samples > 0 ? samples + kLattices - 1 : 0; }
    // Whether all pixels have one sample more after the pass.
    bool endsSample() const { return pass >= kLattices - 1; }

    // Calls f(column) for the columns of the region that the pass samples in a row of it.
    template <class F>
    void forEachColumn(int row, int width, F&& f) const {
        const int step = stepOf(std::min(pass, kLattices - 1));
        if (row % step != 0) return;
        // The previous lattice has already sampled every other column of such a row.
        const bool shared = pass > 0 && pass < kLattices && row % (2 * step) == 0;
        for (int column = shared ? step : 0; column < width; column += shared ? 2 * step : step) f(column);
    }
};

// Fills pixels that have no sample yet, during the first passes, with the value of the nearest sampled pixel up and
// left on a coarser lattice. sampled: a layer of the images' region that every camera sample adds to.
void fillUnsampled(std::initializer_list<Image*> images, const FilmLayer& sampled);
// counts: X, the number of samples of each pixel, of the images' size.
void fillUnsampled(std::initializer_list<Image*> images, const Image& counts);

}  // namespace drc
