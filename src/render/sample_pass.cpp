#include "render/sample_pass.h"

namespace drc {

void fillUnsampled(Image& image, const FilmLayer& sampled) {
    const PixelRegion& region = sampled.region();
    const auto has = [&](int column, int row) { return sampled.expected(region.x0 + column, region.y0 + row) > 0; };
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column) {
            if (has(column, row)) continue;
            for (const int lattice : {2, 4}) {
                const int fromColumn = column - column % lattice, fromRow = row - row % lattice;
                if (!has(fromColumn, fromRow)) continue;
                for (int c = 0; c < image.channels(); ++c) image.at(column, row, c) = image.at(fromColumn, fromRow, c);
                break;
            }
        }
}

}  // namespace drc
