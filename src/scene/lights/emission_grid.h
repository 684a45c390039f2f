// A table for sampling points of a surface in proportion to the radiance of an image on it.
//
// The surface is given as a patch: a mapping from the unit square to the image's (u, v), together with the surface area
// per unit area of the square. The square is divided into cells of about one texel. A cell is chosen in proportion to
// its flux, and the point uniformly within the cell's part of the square. The density at a point then depends only on
// its cell, however the image is mapped to the surface.
#pragma once
#include <functional>

#include "math/distribution.h"
#include "scene/lights/emission.h"

namespace drc {

// At a point of the unit square: the image's (u, v), and the surface area (in any unit) per unit area of the square.
struct PatchPoint {
    Vec2 uv;
    float area = 1;
};
using Patch = std::function<PatchPoint(const Vec2& at)>;

class EmissionGrid {
  public:
    static constexpr int kMostCells = 1 << 18;

    // columns, rows: cells along the sides of the square; both are halved until at most mostCells cells remain. The
    // patch must map lines parallel to the sides of the square to straight lines in (u, v), and is called from several
    // threads.
    EmissionGrid(const EmissionImage& image, int columns, int rows, const Patch& patch, int mostCells = kMostCells);

    // Whether the image varies so little that the surface may as well be sampled uniformly by area. sample() and
    // density() must not be used then.
    bool isUniform() const { return uniform_; }
    int cellCount() const { return distribution_.width() * distribution_.height(); }

    struct Sample {
        Vec2 at;
        float density = 0;  // pdf per unit area of the square
    };
    Sample sample(const Vec2& u) const;
    float density(const Vec2& at) const;

    // Integral of the image over the surface, in the unit of PatchPoint::area.
    const Rgb& integral() const { return integral_; }
    // Approximately the luminance of integral(); the weight for choosing this patch among others. Zero only if the
    // image is black on the whole patch.
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
