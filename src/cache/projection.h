// How the N x N texels of a radiance map cover the hemisphere. Directions are unit vectors in the map's frame, z along
// the normal. Column u and row v run from 0 to N; texel (column, row) covers [column, column+1) x [row, row+1).
#pragma once
#include <string>

#include "math/vec.h"

namespace drc {

enum class Projection {
    // Concentric square-to-disk, lifted so that every texel has the solid angle 2 pi / N^2. u grows with x, v with y.
    EqualArea,
    // The paper's: theta = pi v / N from the y axis, phi = pi u / N from the x axis; the normal is at the centre.
    LatLong,
};

const char* projectionName(Projection p);                // "equal-area", "latlong"
Projection projectionFromName(const std::string& name);  // throws Error

class MapLayout {
  public:
    // size: a power of two; throws Error.
    MapLayout(Projection projection, int size);

    Projection projection() const { return projection_; }
    int size() const { return size_; }
    int texels() const { return size_ * size_; }

    // Direction uniform in solid angle over a texel, u in [0,1)^2; u = (0.5, 0.5) is its centre.
    Vec3 direction(int column, int row, const Vec2& u) const;
    // Continuous texel coordinates (u, v) of a direction, each in [0, N]. A direction below the horizon gets the
    // coordinates of the horizon below which it lies.
    Vec2 coordinates(const Vec3& d) const;
    // Index row * N + column of the texel that a direction falls in.
    int texel(const Vec3& d) const {
        const Vec2 c = coordinates(d);
        const int column = std::clamp(int(c.x), 0, size_ - 1), row = std::clamp(int(c.y), 0, size_ - 1);
        return row * size_ + column;
    }
    // Steradians.
    float solidAngle(int row) const;
    // Of a texel, on average.
    float meanSolidAngle() const { return 2 * kPi / float(texels()); }

  private:
    Projection projection_;
    int size_;
};

// The least alpha of a lobe whose reflections such a map resolves: those of smoother ones are finer than its texels,
// and than what a network's blur leaves. 0.2 for 32x32 texels over a hemisphere, 4.5 degrees each, of which the lobe
// then covers 6.5 at half its maximum (2 atan(alpha sqrt(sqrt(2) - 1)) to either side); in proportion to a texel's
// width.
float broadAlpha(const MapLayout& layout);

}  // namespace drc
