// Adds geometry to a draft in a local frame. Faces are wound outward, so that glass has its inside on the right side.
#pragma once
#include <string>
#include <vector>

#include "generator_draft.h"

namespace drc::interior {

class Pen {
  public:
    Pen(Draft& draft, const Placement& frame) : draft_(&draft), frame_(frame) {}
    // A pen for the same draft, in a frame given in this one's coordinates.
    Pen inner(const Vec3& origin, float yaw) const { return Pen(*draft_, frame_.inner(Placement::at(origin, yaw))); }

    Draft& draft() const { return *draft_; }
    const Placement& frame() const { return frame_; }

    // Corners are anticlockwise as seen from the side of the normal. uv are in metres, or from 0 to 1 with unitUv.
    void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int material, bool unitUv = false) const;
    void triangle(const Vec3& a, const Vec3& b, const Vec3& c, int material) const;
    void box(const Vec3& lo, const Vec3& hi, int material) const;
    // A box with edges bevelled at 45 degrees.
    void bevelledBox(const Vec3& lo, const Vec3& hi, float bevel, int material) const;
    // A surface of revolution around the vertical axis through origin. Profile: (radius, height), upwards along the
    // outside.
    void lathe(const Vec3& origin, const std::vector<Vec2>& profile, int material, int segments = 24) const;
    void cylinder(const Vec3& base, float radius, float height, int material, int segments = 20) const;
    // A lampshade: a single sheet, open at both ends.
    void shade(const Vec3& base, float bottomRadius, float topRadius, float height, int material) const;
    void rod(const Vec3& a, const Vec3& b, float radius, int material) const;
    void sphere(const Vec3& center, float radius, int material) const;
    // A superellipsoid: a box with rounded, bulging sides.
    void cushion(const Vec3& lo, const Vec3& hi, int material, float exponent = 0.4f) const;
    // A sheet with folds that hangs down from a to b.
    void curtain(const Vec3& a, const Vec3& b, float height, float foldDepth, int folds, int material) const;
    // One of pbrt's shapes, with its origin at `at`.
    void shape(const Vec3& at, std::string parameters, int material) const;
    // Occupies a volume without adding geometry.
    void solid(const Vec3& lo, const Vec3& hi) const;
    void surface(const Vec3& center, float halfX, float halfY, float clearance) const;

    // Emitters. The normal of a quad is u x v. Their radiance is set later.
    void quadLight(const Vec3& center, const Vec3& halfU, const Vec3& halfV, int group, int material) const;
    void diskLight(const Vec3& center, const Vec3& normal, float radius, int group, int material) const;
    void sphereLight(const Vec3& center, float radius, int group, int material) const;

  private:
    Draft* draft_;
    Placement frame_;
};

}  // namespace drc::interior
