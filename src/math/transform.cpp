#include "math/transform.h"

namespace drc {
namespace {

Imath::M44d product(const Imath::M44d& a, const Imath::M44d& b) {
    Imath::M44d r(0.0);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < 4; ++k) r[i][j] += a[i][k] * b[k][j];
    return r;
}

}  // namespace

Transform::Transform(const std::array<double, 16>& rowMajor) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) m_[i][j] = rowMajor[4 * i + j];
    // Gauss-Jordan elimination with pivoting. Imath reports a singular matrix by returning the identity.
    const double determinant = m_.determinant();
    invertible_ = determinant != 0 && std::isfinite(determinant);
    inv_ = invertible_ ? m_.gjInverse() : Imath::M44d(0.0);
}

Transform Transform::translate(const Vec3& d) {
    return Transform({1, 0, 0, d.x, 0, 1, 0, d.y, 0, 0, 1, d.z, 0, 0, 0, 1});
}

Transform Transform::scale(float x, float y, float z) {
    return Transform({x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1});
}

Transform Transform::rotate(float degrees, const Vec3& axis) {
    const double l = std::sqrt(double(axis.x) * axis.x + double(axis.y) * axis.y + double(axis.z) * axis.z);
    const double x = axis.x / l, y = axis.y / l, z = axis.z / l;
    const double radians = degrees * std::numbers::pi / 180;
    const double s = std::sin(radians), c = std::cos(radians), k = 1 - c;
    return Transform({x * x * k + c, x * y * k - z * s, x * z * k + y * s, 0,  //
                      y * x * k + z * s, y * y * k + c, y * z * k - x * s, 0,  //
                      z * x * k - y * s, z * y * k + x * s, z * z * k + c, 0, 0, 0, 0, 1});
}

Transform Transform::lookAt(const Vec3& eye, const Vec3& look, const Vec3& up) {
    const Vec3 direction = normalize(look - eye);
    const Vec3 right = normalize(cross(normalize(up), direction));
    const Vec3 newUp = cross(direction, right);
    const Transform cameraToWorld({right.x, newUp.x, direction.x, eye.x,  //
                                   right.y, newUp.y, direction.y, eye.y,  //
                                   right.z, newUp.z, direction.z, eye.z, 0, 0, 0, 1});
    return cameraToWorld.inverse();
}

Transform Transform::perspective(float fovDegrees, float near, float far) {
    const double n = near, f = far;
    const double k = 1 / std::tan(fovDegrees * std::numbers::pi / 360);
    return Transform({k, 0, 0, 0, 0, k, 0, 0, 0, 0, f / (f - n), -f * n / (f - n), 0, 0, 1, 0});
}

Transform Transform::operator*(const Transform& b) const {
    Transform r;
    r.m_ = product(m_, b.m_);
    r.inv_ = product(b.inv_, inv_);
    r.invertible_ = invertible_ && b.invertible_;
    return r;
}

Transform Transform::inverse() const {
    Transform r;
    r.m_ = inv_;
    r.inv_ = m_;
    r.invertible_ = invertible_;
    return r;
}

Transform Transform::transposed() const {
    Transform r;
    r.m_ = m_.transposed();
    r.inv_ = inv_.transposed();
    r.invertible_ = invertible_;
    return r;
}

Vec3 Transform::point(const Vec3& p) const {
    double r[4];
    for (int i = 0; i < 4; ++i) r[i] = m_[i][0] * p.x + m_[i][1] * p.y + m_[i][2] * p.z + m_[i][3];
    const double w = r[3] == 1 ? 1 : 1 / r[3];
    return Vec3(float(r[0] * w), float(r[1] * w), float(r[2] * w));
}

float Transform::largestOfSums(const Vec3& p) const {
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        largest = std::max(largest, std::abs(m_[i][0] * p.x) + std::abs(m_[i][1] * p.y) + std::abs(m_[i][2] * p.z) +
                                        std::abs(m_[i][3]));
    return float(largest);
}

Vec3 Transform::vector(const Vec3& v) const {
    double r[3];
    for (int i = 0; i < 3; ++i) r[i] = m_[i][0] * v.x + m_[i][1] * v.y + m_[i][2] * v.z;
    return Vec3(float(r[0]), float(r[1]), float(r[2]));
}

Vec3 Transform::normal(const Vec3& n) const {
    double r[3];
    for (int i = 0; i < 3; ++i) r[i] = inv_[0][i] * n.x + inv_[1][i] * n.y + inv_[2][i] * n.z;
    return Vec3(float(r[0]), float(r[1]), float(r[2]));
}

bool Transform::swapsHandedness() const {
    const double det = m_[0][0] * (m_[1][1] * m_[2][2] - m_[1][2] * m_[2][1]) -
                       m_[0][1] * (m_[1][0] * m_[2][2] - m_[1][2] * m_[2][0]) +
                       m_[0][2] * (m_[1][0] * m_[2][1] - m_[1][1] * m_[2][0]);
    return det < 0;
}

bool Transform::isIdentity() const { return m_ == Imath::M44d(); }

}  // namespace drc
