// Common implementation of cylinders, cones, paraboloids and hyperboloids: a line, parabola or hyperbola rotated about
// the z axis of object space (PBR 3e, section 3.5).
#pragma once
#include "scene/shapes/quadric_space.h"
#include "scene/shapes/shape.h"

namespace drc {

// The profile curve, parametrised by v in [0, 1]: z = z0 + v dz, and the squared distance to the axis is c[0] + c[1] v
// + c[2] v^2.
struct RevolutionProfile {
    double z0 = 0, dz = 1;
    double c[3] = {1, 0, 0};
    double vMin = 0;  // no surface for smaller v, nor where the squared distance is negative
    // Determines the curve u = 0 and the normals. A Line need not intersect the axis, so the angle of its points around
    // the axis depends on v. A Parabola lies in the plane y = 0. A Hyperbola has the angles and shading normals of the
    // line from p1 to p2, but its own distances to the axis.
    enum class Kind { Line, Parabola, Hyperbola } kind = Kind::Line;
    Vec3d p1{0.0}, p2{0.0};  // ends of the line

    // From p1 (v = 0) to p2 (v = 1), which must differ in z.
    static RevolutionProfile line(const Vec3d& p1, const Vec3d& p2);
    // From zMin (v = 0) to zMax (v = 1), with the apex at the origin and the given radius at zMax.
    static RevolutionProfile parabola(double radius, double zMin, double zMax);
    // The squared distance to the axis is (1 + height z^2) / width, for z from p1.z (v = 0) to p2.z (v = 1).
    static RevolutionProfile hyperbola(const Vec3d& p1, const Vec3d& p2, double width, double height);

    double radiusSquared(double v) const { return c[0] + v * (c[1] + v * c[2]); }
    double radius(double v) const { return std::sqrt(std::max(0.0, radiusSquared(v))); }
    double slope(double v) const { return c[1] + 2 * v * c[2]; }  // derivative of radiusSquared
    double maxRadius() const;
    Vec3d at(double v) const;
    // Object-space area of a full revolution per unit of v, divided by 2 pi.
    double areaElement(double v) const;
};

// Returns null if the surface has no area. u = phi / phiMax (phiMax in degrees), v runs along the curve. ng is along
// cross(dpdu, dpdv) of object space, which points outward if z increases with v; ReverseOrientation flips it.
ShapePtr makeShapeOfRevolution(const Transform& objectToWorld, bool reverseOrientation, float phiMax,
                               const RevolutionProfile& profile);

}  // namespace drc
