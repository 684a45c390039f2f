// The object space of the analytic shapes, in double precision, so that hits are exact up to the rounding of world
// coordinates to float.
#pragma once
#include "math/transform.h"

namespace drc {

using Vec3d = Imath::V3d;

class QuadricSpace {
  public:
    QuadricSpace(const Transform& objectToWorld, bool reverseOrientation) : flip_(reverseOrientation) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) column_[j][i] = objectToWorld.at(i, j);
            origin_[i] = objectToWorld.at(i, 3);
        }
        det_ = column_[0].dot(column_[1].cross(column_[2]));
        // The inverse is computed from column_, whose entries are rounded to float, so that transforming there and back
        // gives the same point.
        for (int i = 0; i < 3; ++i) inverseRow_[i] = column_[(i + 1) % 3].cross(column_[(i + 2) % 3]) / det_;
        // Spheres stay spheres if the columns are perpendicular and of equal length.
        const double s2 = column_[0].length2(), tolerance = 1e-5 * s2;
        conformal_ = std::abs(column_[1].length2() - s2) < tolerance && std::abs(column_[2].length2() - s2) < tolerance;
        for (int i = 0; i < 3; ++i)
            conformal_ = conformal_ && std::abs(column_[i].dot(column_[(i + 1) % 3])) < tolerance;
    }

    Vec3d pointToObject(const Vec3& p) const { return vectorToObject(Vec3d(p) - origin_); }
    Vec3d vectorToObject(const Vec3d& v) const {
        return Vec3d(inverseRow_[0].dot(v), inverseRow_[1].dot(v), inverseRow_[2].dot(v));
    }
    Vec3d pointToWorld(const Vec3d& p) const { return origin_ + vectorToWorld(p); }
    Vec3d vectorToWorld(const Vec3d& v) const { return column_[0] * v.x + column_[1] * v.y + column_[2] * v.z; }
    // World-space unit normal for the object-space normal cross(dpdu, dpdv): transformed as a normal, so that it stays
    // on the outside under mirroring, and flipped by ReverseOrientation. (pbrt also flips it under mirroring, but not
    // where it samples the surface as a light, so that its mirrored lamps lose a part of their light.)
    Vec3 normalToWorld(const Vec3d& n) const {
        const Vec3d w = inverseTransposed(n).normalized();
        return Vec3(flip_ ? -w : w);
    }
    // Inverse of normalToWorld(), up to the sign.
    Vec3d normalToObject(const Vec3& n) const {
        const Vec3d w(n);
        return Vec3d(column_[0].dot(w), column_[1].dot(w), column_[2].dot(w)).normalized();
    }
    // Ratio of world-space to object-space area, for a surface with the unit normal n in object space.
    double areaScale(const Vec3d& n) const { return std::abs(det_) * inverseTransposed(n).length(); }

    // Mean of areaScale() over a surface, where normalAt(u, v) is the unit normal at points that are uniform by area in
    // object space. Uses the centres of kAreaSteps^2 equal cells of the unit square. Exact if the transform is
    // conformal, since the scale is then the same everywhere.
    static constexpr int kAreaSteps = 64;
    template <typename NormalAt>
    double meanAreaScale(const NormalAt& normalAt) const {
        if (conformal_) return areaScale(normalAt(0.5, 0.5));
        double sum = 0;
        for (int i = 0; i < kAreaSteps; ++i)
            for (int j = 0; j < kAreaSteps; ++j)
                sum += areaScale(normalAt((i + 0.5) / kAreaSteps, (j + 0.5) / kAreaSteps));
        return sum / (kAreaSteps * kAreaSteps);
    }

    bool conformal() const { return conformal_; }
    double scale() const { return column_[0].length(); }  // scale of lengths, if conformal
    const Vec3d& origin() const { return origin_; }
    // Length of row i of the linear part: half the extent of a transformed unit sphere along world axis i.
    double extent(int i) const { return Vec3d(column_[0][i], column_[1][i], column_[2][i]).length(); }

  private:
    Vec3d inverseTransposed(const Vec3d& n) const {
        return inverseRow_[0] * n.x + inverseRow_[1] * n.y + inverseRow_[2] * n.z;
    }

    Vec3d column_[3], origin_, inverseRow_[3];
    double det_;
    bool conformal_;
    bool flip_;
};
// t0, t1: both intersections of a ray with a quadric, in any order. Returns the nearer hit in (tMin, tMax) for which
// hitAt(t) finds a point on the part of the quadric that exists.
template <typename HitAt>
auto nearerHit(double t0, double t1, double tMin, double tMax, const HitAt& hitAt) -> decltype(hitAt(t0)) {
    if (t0 > t1) std::swap(t0, t1);
    for (const double t : {t0, t1}) {
        if (!(t > tMin && t < tMax)) continue;
        if (auto hit = hitAt(t)) return hit;
    }
    return {};
}

// Converts a pdf per area at `to`, where the unit normal is ng, to one per solid angle at `from` (PBR 3e, section
// 5.5.3). Zero if the surface is seen edge-on, because no light arrives from it.
inline float toSolidAngle(float pdf, const Vec3& from, const Vec3& to, const Vec3& ng) {
    const Vec3d d = Vec3d(to) - Vec3d(from);
    const double cosineTimesD = std::abs(Vec3d(ng).dot(d));
    const double r = pdf * d.length2() * d.length() / cosineTimesD;
    return std::isfinite(r) && cosineTimesD > 0 ? float(r) : 0.f;
}

}  // namespace drc
