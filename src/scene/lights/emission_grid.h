// A table for sampling points of a surface in proportion to the radiance of an image on it.
//
// The surface is given as a patch: a mapping from the unit square to the image's (u, v), with the surface's area per
// unit of the square. The square is divided into cells of about a texel each. A cell is chosen by its flux, and the
// point in it uniformly on the square, so that the density is known for any point, however the image lies on the
// surface.
#pragma once
#include <functional>

#include "math/distribution.h"
#include "scene/lights/emission.h"

namespace drc {

// The image's coordinates at a point of the square, and the surface's area per unit of the square there, which may be
// in any unit.
struct PatchPoint {
    Vec2 uv;
    float area = 1;
};
using Patch = std::function<PatchPoint(const Vec2& at)>;

class EmissionGrid {
  public:
    static constexpr int kMostCells = 1 << 18;

    // columns, rows: into how many cells the square is divided, which is halved until no more than mostCells are left.
    // The patch must map straight lines along the sides of the square to straight lines in (u, v), and may be called
    // from several threads.
    EmissionGrid(const EmissionImage& image, int columns, int rows, const Patch& patch, int mostCells = kMostCells);

    // Whether the image varies so little that the surface may as well be sampled uniformly by area. The table is then
    // not to be used.
    bool isUniform() const { return uniform_; }
    int cellCount() const { return distribution_.width() * distribution_.height(); }

    struct Sample {
        Vec2 at;
        float density = 0;  // per unit of the square
    };
    Sample sample(const Vec2& u) const;
    float density(const Vec2& at) const;

    // Integral of the image over the surface, in units of the patch's area.
    const Rgb& integral() const { return integral_; }
    // About the luminance of integral(), by which the patch should be chosen among others. Zero only where all of it is
    // black.
    double weight() const { return weight_; }

  private:
    struct Cell {
        double weight = 0, area = 0;
        double flux[3] = {};
    };
    static Cell cellOf(const EmissionImage& image, const Patch& patch, const Vec2& low, const Vec2& high);

    Distribution2D distribution_;
    Rgb integral_{0.f};
    double weight_ = 0;
    bool uniform_ = true;
};

}  // namespace drc
