// A rectangular opening through which the light of an environment enters, and rectified coordinates of directions, in
// which the portal is a rectangle as seen from every point behind it (Bitterli et al. 2015; PBR 4e, section 12.5.3):
// for a direction (x, y, z) in the portal's frame, whose z axis is the normal, they are atan2(x, z) / pi + 1/2 and
// atan2(y, z) / pi + 1/2.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "math/frame.h"
#include "math/windowed_distribution.h"

namespace drc {

class Portal {
  public:
    // The corners in order, in world space. As in pbrt-v4, light enters against the direction of
    // cross(corners[3] - corners[0], corners[1] - corners[0]).
    explicit Portal(const std::array<Vec3, 4>& corners);
    // Why the corners are not those of a rectangle in this order; empty if they are.
    static std::string flawOf(const std::array<Vec3, 4>& corners);

    const Vec3& outward() const { return frame_.n; }
    // s and t along the sides, n outward.
    const Frame& frame() const { return frame_; }
    float area() const { return width_ * height_; }
    std::array<Vec3, 4> corners() const;
    // u in the unit square.
    Vec3 pointAt(const Vec2& u) const { return corner_ + frame_.s * (u.x * width_) + frame_.t * (u.y * height_); }

    // Whether p is on the inner side of the portal's plane.
    bool faces(const Vec3& p) const { return dot(corner_ - p, frame_.n) > 0; }
    // Whether a ray from p in direction w passes the portal from the inside.
    bool isPassed(const Vec3& p, const Vec3& w) const;
    // The rectangle of rectified coordinates that the portal covers as seen from p; empty if p is outside.
    std::optional<Window> windowFrom(const Vec3& p) const;

    // A direction (unit, world space), with the solid angle per unit area of rectified coordinates.
    struct Direction {
        Vec3 w;
        float solidAngle = 0;
        float cosine = 0;  // to outward()
    };
    Direction directionOf(const Vec2& rectified) const;
    // Rectified coordinates of a direction. rectifiedOf() returns none for directions that lead inside.
    struct Rectified {
        Vec2 at;
        float solidAngle = 0, cosine = 0;
    };
    std::optional<Rectified> rectifiedOf(const Vec3& w) const;

  private:
    Vec3 corner_;
    Frame frame_;
    float width_, height_;
};

}  // namespace drc
