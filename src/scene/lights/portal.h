// A rectangular opening through which the light of an environment enters, and the rectified coordinates of directions
// in which every point behind it sees it as a rectangle (Bitterli et al. 2015; PBR 4e, section 12.5.3): the angles of a
// direction to the portal's normal, in the planes of the normal and one of its sides each, divided by pi.
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

    // Whether p is inside.
    bool faces(const Vec3& p) const { return dot(corner_ - p, frame_.n) > 0; }
    // Whether a ray from p in direction w passes the portal from the inside.
    bool isPassed(const Vec3& p, const Vec3& w) const;
    // The window that p sees through the portal, in rectified coordinates; none from outside.
    std::optional<Window> windowFrom(const Vec3& p) const;

    // A direction, unit, with the solid angle per unit of rectified coordinates.
    struct Direction {
        Vec3 w;
        float solidAngle = 0;
        float cosine = 0;  // to outward()
    };
    Direction directionOf(const Vec2& rectified) const;
    // None for directions that lead inside.
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
