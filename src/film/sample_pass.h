// Sample passes: passes of camera samples over the film. The first sample of every pixel is spread over three passes,
// which cover every fourth row and column, then every second, then the rest, so that a coarse picture of the whole film
// appears early. Each later pass takes one sample in every pixel.
#pragma once
#include <algorithm>
#include <cstdint>
#include <initializer_list>

#include "film/film_layer.h"
#include "image/image.h"

namespace drc {

// The indices, within a pixel, of the samples that a pass takes there.
struct PixelSamples {
    uint32_t first = 0;
    int count = 1;
};

struct SamplePass {
    static constexpr int kLattices = 3;

    int pass = 0;  // counts from 0

    // The distance between the rows, and between the columns, of a lattice, in pixels.
    static int stepOf(int lattice) { return 4 >> lattice; }

    // The index, within a pixel, of the sample that this pass takes.
    uint32_t sample() const { return uint32_t(std::max(0, pass - (kLattices - 1))); }
    // The number of samples that every pixel has after `passes` passes; and the number of passes for `samples` samples.
    static int wholeSamples(int passes) { return std::max(0, passes - (kLattices - 1)); }
    static int passesFor(int samples) { return samples > 0 ? samples + kLattices - 1 : 0; }
    // Whether this pass completes a sample in every pixel.
    bool endsSample() const { return pass >= kLattices - 1; }

    // Calls f(column) for the columns that this pass samples in a row. Rows and columns count from the region's corner.
    template <class F>
    void forEachColumn(int row, int width, F&& f) const {
        const int step = stepOf(std::min(pass, kLattices - 1));
        if (row % step != 0) return;
        // The previous lattice has already sampled every other column of such a row.
        const bool shared = pass > 0 && pass < kLattices && row % (2 * step) == 0;
        for (int column = shared ? step : 0; column < width; column += shared ? 2 * step : step) f(column);
    }
};

// During the first passes, fills each pixel without samples with the value of a sampled pixel above and to the left, on
// the finest coarser lattice that has one. sampled: a layer that every camera sample adds to, with the region of the
// images.
void fillUnsampled(std::initializer_list<Image*> images, const FilmLayer& sampled);
// counts: X, the number of samples of each pixel; same size as the images.
void fillUnsampled(std::initializer_list<Image*> images, const Image& counts);

}  // namespace drc
