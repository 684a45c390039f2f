// What cylinders, cones, paraboloids and hyperboloids have in common: a line, a parabola or a hyperbola turned about
// the z axis of object space (PBR 3e, section 3.5).
#pragma once
#include "scene/quadric_space.h"
#include "scene/shape.h"

namespace drc {

// The curve that is turned. With v from 0 to 1 along it: z = z0 + v dz, and the square of the distance to the axis is
// c[0] + c[1] v + c[2] v^2.
struct RevolutionProfile {
    double z0 = 0, dz = 1;
    double c[3] = {1, 0, 0};
    double vMin = 0;  // there is no surface below, nor where that square is negative
    // Which u counts as zero and along what v runs. A line need not meet the axis: the angle of its points about it
    // depends on v. A parabola lies in the plane y = 0. A hyperbola has its points where the line has them, but for the
    // distance to the axis, and is shaded with the normals of what the line would sweep.
    enum class Kind { Line, Parabola, Hyperbola } kind = Kind::Line;
    Vec3d p1{0.0}, p2{0.0};  // of the line

    // From p1 (v = 0) to p2 (v = 1), which differ in z.
    static RevolutionProfile line(const Vec3d& p1, const Vec3d& p2);
    // From zMin (v = 0) to zMax (v = 1), apex at the origin, with that radius at zMax.
    static RevolutionProfile parabola(double radius, double zMin, double zMax);
    // The square of the distance to the axis is (1 + height z^2) / width, for z from p1's (v = 0) to p2's (v = 1).
    static RevolutionProfile hyperbola(const Vec3d& p1, const Vec3d& p2, double width, double height);

    double radiusSquared(double v) const { return c[0] + v * (c[1] + v * c[2]); }
    double radius(double v) const { return std::sqrt(std::max(0.0, radiusSquared(v))); }
    double slope(double v) const { return c[1] + 2 * v * c[2]; }  // derivative of radiusSquared
    double maxRadius() const;
    Vec3d at(double v) const;
    // Area of object space for a step in v and a full turn, over 2 pi.
    double areaElement(double v) const;
};

// Null if the curve has no points. u = phi / phiMax, v along the curve. phiMax in degrees. ng points to the side of
// cross(dpdu, dpdv), which is outward where z grows with v, turned by ReverseOrientation and by a transform that swaps
// handedness as in pbrt.
ShapePtr makeShapeOfRevolution(const Transform& objectToWorld, bool reverseOrientation, float phiMax,
                               const RevolutionProfile& profile);

}  // namespace drc
