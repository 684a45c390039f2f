// Where a map pass places its radiance maps on the film: a regular grid whose spacing shrinks from pass to pass, and
// buckets for additional maps where the grid's maps do not suffice.
#pragma once
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace drc {

// The paper's spacing: 100 pixels at a film height of 720, proportional to the height. It shrinks so that each pass has
// 1.257 times as many maps as the previous one.
inline constexpr float kFirstSpacing = 100.f / 720.f;  // fraction of the film's height
inline constexpr float kSpacingFactor = 0.891859f;

// Grid spacing of pass 0, 1, 2, ... in pixels; at least 1.
float passSpacing(int pass, int filmHeight, float firstSpacing = kFirstSpacing);

// The least number of whole passes that complete `tasks` tasks, the paper's unit of quality. A task is a square of ten
// by ten grid cells.
int passesForTasks(int tasks, int width, int height);

// A grid of points that covers a region of the film and extends one cell beyond it, so that every pixel is in a cell.
class MapGrid {
  public:
    // spacing in pixels; offset in [0,1)^2, in cells.
    MapGrid(const PixelRegion& region, float spacing, const Vec2& offset);
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    int count() const { return columns_ * rows_; }
    float spacing() const { return spacing_; }
    Vec2 point(int index) const {
        return Vec2(origin_.x + spacing_ * float(index % columns_), origin_.y + spacing_ * float(index / columns_));
    }
    // Index of the upper left corner of the cell that contains a film position. The cell's other corners are index + 1,
    // index + columns() and index + columns() + 1.
    int cell(const Vec2& film) const;
    // The y coordinate of a row of grid points on the film, in pixels.
    float rowAt(int row) const { return origin_.y + spacing_ * float(row); }

  private:
    float spacing_;
    Vec2 origin_;
    int columns_, rows_;
};

// A uniform spatial hash of points on a region of the film. Visits all points within `reach` pixels of a position, and
// possibly some beyond, which the caller must reject.
class FilmBuckets {
  public:
    FilmBuckets(const PixelRegion& region, float reach);
    void add(const Vec2& film, int id);
    template <typename F>
    void forEachNear(const Vec2& film, F&& f) const {
        const int cx = cellX(film.x), cy = cellY(film.y);
        for (int y = std::max(0, cy - 1); y <= std::min(rows_ - 1, cy + 1); ++y)
            for (int x = std::max(0, cx - 1); x <= std::min(columns_ - 1, cx + 1); ++x)
                for (const int id : cells_[size_t(y * columns_ + x)]) f(id);
    }
    float reach() const { return reach_; }

  private:
    int cellX(float x) const { return std::clamp(int((x - origin_.x) / reach_), 0, columns_ - 1); }
    int cellY(float y) const { return std::clamp(int((y - origin_.y) / reach_), 0, rows_ - 1); }
    Vec2 origin_;
    float reach_;
    int columns_, rows_;
    std::vector<std::vector<int>> cells_;
};

}  // namespace drc
