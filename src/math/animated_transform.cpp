#include "math/animated_transform.h"

#include <Imath/ImathMatrixAlgo.h>
#include <Imath/ImathQuat.h>

#include <algorithm>
#include <variant>
#include <vector>

namespace drc {
namespace {

using Matrix = Imath::M33d;  // m[row][column], column vectors

Matrix linearPart(const Transform& t) {
    Matrix m;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) m[row][column] = t.at(row, column);
    return m;
}

// Product of the matrices of column vectors: first b, then a. Imath's operator* multiplies in the other order.
Matrix product(const Matrix& a, const Matrix& b) {
    Matrix r(0, 0, 0, 0, 0, 0, 0, 0, 0);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) r[i][j] += a[i][k] * b[k][j];
    return r;
}

// The orthogonal factor of the polar decomposition of m: a rotation, or a rotation with a reflection if m mirrors.
// Found by repeatedly averaging the matrix with its inverse transpose (Shoemake and Duff, "Matrix Animation and Polar
// Decomposition", 1992).
Matrix polarRotation(Matrix m) {
    constexpr int kMost = 100;
    for (int i = 0; i < kMost; ++i) {
        const Matrix next = (m + m.inverse().transposed()) * 0.5;
        double change = 0;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                change = std::max(change, std::abs(next[row][column] - m[row][column]));
        m = next;
        if (change < 1e-14) break;
    }
    return m;
}

// The decomposition of an affine transform into translation * rotation * stretch.
struct Pose {
    Imath::V3d translation;
    Imath::Quatd rotation;
    Matrix stretch;  // symmetric; with negative eigenvalues if the transform mirrors

    explicit Pose(const Transform& t) {
        for (int i = 0; i < 3; ++i) translation[i] = t.at(i, 3);
        const Matrix m = linearPart(t);
        Matrix r = polarRotation(m);
        if (r.determinant() < 0) r = r * -1.0;
        stretch = product(r.transposed(), m);
        Imath::M44d rowVectors;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) rowVectors[i][j] = r[j][i];
        rotation = Imath::extractQuat(rowVectors);
    }

    bool stretchesAlongAxes() const {
        double off = 0, on = 0;
        for (int i = 0; i < 3; ++i) {
            on = std::max(on, std::abs(stretch[i][i]));
            off = std::max(off, std::abs(stretch[i][(i + 1) % 3]));
        }
        return off < 1e-6 * on;
    }
};

Transform between(const Pose& a, const Pose& b, double t) {
    const Imath::V3d translation = a.translation * (1 - t) + b.translation * t;
    const Matrix rotation = Imath::slerpShortestArc(a.rotation, b.rotation, t).normalized().toMatrix33().transposed();
    const Matrix linear = product(rotation, a.stretch * (1 - t) + b.stretch * t);
    return Transform({linear[0][0], linear[0][1], linear[0][2], translation.x,  //
                      linear[1][0], linear[1][1], linear[1][2], translation.y,  //
                      linear[2][0], linear[2][1], linear[2][2], translation.z, 0, 0, 0, 1});
}

struct PoseToPose {
    Pose start, end;
};
using Factor = std::variant<Transform, PoseToPose>;

}  // namespace

struct AnimatedTransform::Motion {
    Transform end;
    std::vector<Factor> factors;  // in the order of the product, the leftmost first
};

AnimatedTransform::AnimatedTransform(const Transform& start, const Transform& end) : start_(start) {
    if (start == end) return;
    motion_ = std::make_shared<const Motion>(Motion{end, {PoseToPose{Pose(start), Pose(end)}}});
}

const Transform& AnimatedTransform::end() const { return motion_ ? motion_->end : start_; }

Transform AnimatedTransform::at(float time) const {
    if (motion_ == nullptr || !(time > 0)) return start_;
    if (time >= 1) return motion_->end;
    Transform result;
    for (const Factor& factor : motion_->factors) {
        if (const auto* moving = std::get_if<PoseToPose>(&factor))
            result = result * between(moving->start, moving->end, time);
        else
            result = result * std::get<Transform>(factor);
    }
    return result;
}

AnimatedTransform operator*(const AnimatedTransform& a, const AnimatedTransform& b) {
    AnimatedTransform result(a.start_ * b.start_);
    if (!a.isAnimated() && !b.isAnimated()) return result;
    AnimatedTransform::Motion motion{a.end() * b.end(), {}};
    for (const AnimatedTransform* factor : {&a, &b}) {
        if (factor->motion_)
            motion.factors.insert(motion.factors.end(), factor->motion_->factors.begin(),
                                  factor->motion_->factors.end());
        else if (!factor->start_.isIdentity())
            motion.factors.emplace_back(factor->start_);
    }
    result.motion_ = std::make_shared<const AnimatedTransform::Motion>(std::move(motion));
    return result;
}

unsigned AnimatedTransform::steps() const {
    if (motion_ == nullptr) return 1;
    if (motion_->factors.size() != 1) return kMostSteps;
    const auto* only = std::get_if<PoseToPose>(&motion_->factors[0]);
    return only != nullptr && only->start.stretchesAlongAxes() && only->end.stretchesAlongAxes() ? 2 : kMostSteps;
}

}  // namespace drc
