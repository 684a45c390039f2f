// An affine (or projective) transform together with its inverse. It acts on column vectors: (a * b)(p) = a(b(p)), as in
// pbrt.
#pragma once
#include <Imath/ImathMatrix.h>

#include <array>

#include "math/vec.h"

namespace drc {

class Transform {
  public:
    Transform() = default;
    // Row-major 4x4 matrix acting on column vectors. The inverse of a singular matrix is set to zero; see
    // isInvertible().
    explicit Transform(const std::array<double, 16>& rowMajor);

    static Transform translate(const Vec3& d);
    static Transform scale(float x, float y, float z);
    // Right-handed rotation by an angle in degrees.
    static Transform rotate(float degrees, const Vec3& axis);
    // World-to-camera transform of pbrt's LookAt directive: the camera is at the origin and looks along +z, in a
    // left-handed system.
    static Transform lookAt(const Vec3& eye, const Vec3& look, const Vec3& up);
    // Perspective projection of the depth range [near, far]; field of view in degrees (PBR 3e, section 6.2.2).
    static Transform perspective(float fovDegrees, float near, float far);

    Transform operator*(const Transform& b) const;
    Transform inverse() const;
    Transform transposed() const;

    Vec3 point(const Vec3& p) const;  // divides by w
    // Bound on the magnitude of the terms summed in point(p): the largest coordinate of |M| |p|. The rounding error of
    // point(p) in floats is proportional to it. For affine transforms only.
    float largestOfSums(const Vec3& p) const;
    Vec3 vector(const Vec3& v) const;  // ignores the translation
    Vec3 normal(const Vec3& n) const;  // multiplies by the inverse transpose; does not normalise
    bool swapsHandedness() const;
    bool isInvertible() const { return invertible_; }
    bool isIdentity() const;
    // Entry of the matrix that acts on column vectors.
    float at(int row, int column) const { return static_cast<float>(m_[row][column]); }
    bool operator==(const Transform& b) const { return m_ == b.m_; }

  private:
    Imath::M44d m_;  // m_[row][column], acting on column vectors
    Imath::M44d inv_;
    bool invertible_ = true;
};

}  // namespace drc
