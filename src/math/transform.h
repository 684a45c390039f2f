// An affine (or projective) transform with its inverse. Column vectors: (a * b)(p) = a(b(p)), as in pbrt.
#pragma once
#include <Imath/ImathMatrix.h>

#include <array>

#include "math/vec.h"

namespace drc {

class Transform {
  public:
    Transform() = default;
    // Row-major 4x4 matrix that acts on column vectors. A singular matrix gives a zero inverse; see isInvertible.
    explicit Transform(const std::array<double, 16>& rowMajor);

    static Transform translate(const Vec3& d);
    static Transform scale(float x, float y, float z);
    // Right-handed rotation, degrees.
    static Transform rotate(float degrees, const Vec3& axis);
    // World-to-camera transform of pbrt's LookAt: camera at the origin, looking along +z, left-handed.
    static Transform lookAt(const Vec3& eye, const Vec3& look, const Vec3& up);
    // Perspective projection of depth range [near, far], field of view in degrees (PBR 3e, section 6.2.2).
    static Transform perspective(float fovDegrees, float near, float far);

    Transform operator*(const Transform& b) const;
    Transform inverse() const;
    Transform transposed() const;

    Vec3 point(const Vec3& p) const;  // divides by w
    // Of the sums that point(p)'s coordinates are, the largest if no term had a sign: how exact they can be in floats.
    // For affine transforms.
    float largestOfSums(const Vec3& p) const;
    Vec3 vector(const Vec3& v) const;  // no translation
    Vec3 normal(const Vec3& n) const;  // by the inverse transpose; not renormalised
    bool swapsHandedness() const;
    bool isInvertible() const { return invertible_; }
    bool isIdentity() const;
    // Row-major, acting on column vectors.
    float at(int row, int column) const { return static_cast<float>(m_[row][column]); }
    bool operator==(const Transform& b) const { return m_ == b.m_; }

  private:
    Imath::M44d m_;  // m_[row][column], column vectors
    Imath::M44d inv_;
    bool invertible_ = true;
};

}  // namespace drc
