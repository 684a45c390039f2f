#include "film/sample_pass.h"

#include "base/parallel.h"

namespace drc {

namespace {

// has(column, row): whether a pixel has samples.
template <class Has>
void fill(std::initializer_list<Image*> images, int width, int height, const Has& has) {
    // Reads only sampled pixels and writes only unsampled ones, so rows may be filled in any order.
    const auto fillPixel = [&](int column, int row) {
        for (const int lattice : {2, 4}) {
            const int fromColumn = column - column % lattice, fromRow = row - row % lattice;
            if (!has(fromColumn, fromRow)) continue;
            for (Image* image : images)
                std::copy_n(image->pixel(fromColumn, fromRow), image->channels(), image->pixel(column, row));
            return;
        }
    };
    parallelFor(0, height, 8, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < width; ++column)
                if (!has(column, row)) fillPixel(column, row);
    });
}

}  // namespace

void fillUnsampled(std::initializer_list<Image*> images, const FilmLayer& sampled) {
    const PixelRegion& region = sampled.region();
    fill(images, region.width(), region.height(),
         [&](int column, int row) { return sampled.expected(region.x0 + column, region.y0 + row) > 0; });
}

void fillUnsampled(std::initializer_list<Image*> images, const Image& counts) {
    fill(images, counts.width(), counts.height(), [&](int column, int row) { return counts.at(column, row, 0) > 0; });
}

}  // namespace drc
