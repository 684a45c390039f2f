#include "maps/map_grid.h"

namespace drc {

float passSpacing(int pass, int filmHeight, float firstSpacing) {
    return std::max(1.f, firstSpacing * float(filmHeight) * std::pow(kSpacingFactor, float(pass)));
}

int passesForTasks(int tasks, int width, int height) {
    int passes = 0;
    for (int done = 0; done < tasks; ++passes) {
        const int side = 10 * int(passSpacing(passes, height));
        done += ((width + side - 1) / side) * ((height + side - 1) / side);
    }
    return passes;
}

MapGrid::MapGrid(const PixelRegion& region, float spacing, const Vec2& offset)
    : spacing_(spacing),
      origin_(float(region.x0) + (offset.x - 1) * spacing, float(region.y0) + (offset.y - 1) * spacing) {
    const auto cover = [&](float origin, int end) {
        return std::max(2, int(std::ceil((float(end) - origin) / spacing)) + 1);
    };
    columns_ = cover(origin_.x, region.x1);
    rows_ = cover(origin_.y, region.y1);
}

int MapGrid::cell(const Vec2& film) const {
    const int x = std::clamp(int(std::floor((film.x - origin_.x) / spacing_)), 0, columns_ - 2);
    const int y = std::clamp(int(std::floor((film.y - origin_.y) / spacing_)), 0, rows_ - 2);
    return y * columns_ + x;
}

FilmBuckets::FilmBuckets(const PixelRegion& region, float reach)
    : origin_(float(region.x0), float(region.y0)),
      reach_(reach),
      columns_(int(float(region.width()) / reach) + 1),
      rows_(int(float(region.height()) / reach) + 1) {
    cells_.resize(size_t(columns_) * size_t(rows_));
}

void FilmBuckets::add(const Vec2& film, int id) {
    cells_[size_t(cellY(film.y) * columns_ + cellX(film.x))].push_back(id);
}

}  // namespace drc
