// The linear part of a transform in single precision, stored as the transformed x, y and z axes. (Transform uses
// doubles.)
#pragma once
#include "math/transform.h"

namespace drc {

struct Turn {
    Vec3 x, y, z;
    explicit Turn(const Transform& t)
        : x(t.vector(Vec3(1, 0, 0))), y(t.vector(Vec3(0, 1, 0))), z(t.vector(Vec3(0, 0, 1))) {}
    Vec3 operator()(const Vec3& v) const { return x * v.x + y * v.y + z * v.z; }
    // Whether angles are preserved: rotations, reflections and uniform scales.
    bool keepsAngles() const {
        const float l2 = lengthSquared(x);
        const auto same = [l2](const Vec3& v) { return std::abs(lengthSquared(v) - l2) < 1e-4f * l2; };
        return l2 > 0 && same(y) && same(z) &&
               std::abs(dot(x, y)) + std::abs(dot(y, z)) + std::abs(dot(z, x)) < 1e-4f * l2;
    }
};

}  // namespace drc
