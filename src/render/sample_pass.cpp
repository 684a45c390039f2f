#include "render/sample_pass.h"

#include "base/parallel.h"

namespace drc {

void fillUnsampled(std::initializer_list<Image*> images, const FilmLayer& sampled) {
    const PixelRegion& region = sampled.region();
    const auto has = [&](int column, int row) { return sampled.expected(region.x0 + column, region.y0 + row) > 0; };
    // Reads sampled pixels alone and writes only others, so that rows may be filled in any order.
    const auto fill = [&](int column, int row) {
        for (const int lattice : {2, 4}) {
            const int fromColumn = column - column % lattice, fromRow = row - row % lattice;
            if (!has(fromColumn, fromRow)) continue;
            for (Image* image : images)
                std::copy_n(image->pixel(fromColumn, fromRow), image->channels(), image->pixel(column, row));
            return;
        }
    };
    parallelFor(0, region.height(), 8, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < region.width(); ++column)
                if (!has(column, row)) fill(column, row);
    });
}

}  // namespace drc
