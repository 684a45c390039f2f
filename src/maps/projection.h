// How the N x N texels of a radiance map cover the hemisphere. Directions are unit vectors in the map's frame, whose z
// axis is the surface normal. u runs along columns and v along rows, both from 0 to N; texel (column, row) covers
// [column, column + 1) x [row, row + 1).
#pragma once
#include <string>

#include "math/vec.h"

namespace drc {

enum class Projection {
    // Concentric mapping of the square to the disk, lifted to the hemisphere. Every texel has the solid angle 2 pi /
    // N^2. u increases along x, v along y.
    EqualArea,
    // The paper's projection: theta = pi v / N from the y axis and phi = pi u / N from the x axis; the normal is at the
    // map's centre.
    LatLong,
};

const char* projectionName(Projection p);                // "equal-area" or "latlong"
Projection projectionFromName(const std::string& name);  // throws Error for any other name

class MapLayout {
  public:
    // size: number of texels along a side. Throws Error unless it is a power of two.
    MapLayout(Projection projection, int size);

    Projection projection() const { return projection_; }
    int size() const { return size_; }
    int texels() const { return size_ * size_; }

    // Direction of the point u in [0,1)^2 within a texel, uniform in solid angle; u = (0.5, 0.5) is the texel's centre.
    Vec3 direction(int column, int row, const Vec2& u) const;
    // Continuous texel coordinates (u, v) of a direction, each in [0, N]. Directions below the horizon are clamped to
    // the horizon.
    Vec2 coordinates(const Vec3& d) const;
    // Index row * N + column of the texel that contains a direction.
    int texel(const Vec3& d) const {
        const Vec2 c = coordinates(d);
        const int column = std::clamp(int(c.x), 0, size_ - 1), row = std::clamp(int(c.y), 0, size_ - 1);
        return row * size_ + column;
    }
    // Solid angle of each texel in a row, in steradians.
    float solidAngle(int row) const;
    // Mean solid angle of a texel, in steradians.
    float meanSolidAngle() const { return 2 * kPi / float(texels()); }

  private:
    Projection projection_;
    int size_;
};

// The least roughness alpha of a lobe whose reflections a map of this layout resolves: reflections of smoother lobes
// are finer than its texels, and finer than what a network's blur leaves. It is 0.2 for 32x32 texels over a hemisphere.
// There, a texel is 4.5 degrees wide, and the lobe is 6.5 texels wide at half its maximum (2 atan(alpha sqrt(sqrt(2) -
// 1)) to either side). Proportional to the width of a texel.
float broadAlpha(const MapLayout& layout);

}  // namespace drc
