#include "pbrt/scene_limits.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/limits.h"
#include "scene/shapes/projected_shape.h"

namespace drc::pbrt {
namespace {

using Affine = std::array<Vec3, 4>;  // columns; the last is the translation

float largest(const Affine& m) {
    float most = 0;
    for (const Vec3& column : m)
        for (int row = 0; row < 3; ++row) most = std::max(most, std::abs(column[row]));
    return most;
}

Affine affine(const Transform& t) {
    Affine m;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) m[size_t(column)][row] = t.at(row, column);
    return m;
}

// The inverse as Embree computes it in floats: cofactors divided by the determinant. Where float precision does not
// suffice, it is far from the true inverse, or not finite.
Affine floatInverse(const Affine& m) {
    const Vec3 rows[3] = {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
    const float scale = 1 / dot(m[0], rows[0]);
    Affine r;
    for (int i = 0; i < 3; ++i) {
        for (int column = 0; column < 3; ++column) r[size_t(column)][i] = rows[i][column] * scale;
        r[3][i] = -dot(rows[i], m[3]) * scale;
    }
    return r;
}

// Whether rounding errors of the determinant are below half its value.
bool hasFloatDeterminant(const Affine& m) {
    float determinant = 0, products = 0;
    for (int i = 0; i < 3; ++i)
        for (const int turn : {1, 2}) {
            const float product = m[0][i] * m[1][(i + turn) % 3] * m[2][(i + 2 * turn) % 3];
            determinant += turn == 1 ? product : -product;
            products += std::abs(product);
        }
    return std::abs(determinant) > 1e-6f * products;
}

}  // namespace

bool isUsable(const Transform& t) {
    const Transform inverse = t.inverse();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            if (!std::isfinite(t.at(row, column)) || !std::isfinite(inverse.at(row, column))) return false;
    return t.isInvertible();
}

void checkPlacement(const AnimatedTransform& objectToWorld, const SourcePos& pos) {
    if (!isAffine(objectToWorld.start()) || !isAffine(objectToWorld.end()))
        fail(
            pos,
            "instances, and what moves, cannot have a transformation with perspective: the last row of its matrix must "
            "be 0 0 0 1");
    constexpr int kMoments = 9;  // the stretch is interpolated linearly between these
    for (int i = 0; i < (objectToWorld.isAnimated() ? kMoments : 1); ++i) {
        const Transform t = objectToWorld.at(float(i) / (kMoments - 1));
        const Affine placement = affine(t);
        const float most = largest(affine(t.inverse())), inFloats = largest(floatInverse(placement));
        if (!(most <= limits::kInstanceScale))
            fail(pos, "an object may be made smaller by a factor of 1e9 at most, and moved by 1e9 times its own size");
        if (!(inFloats > 0.5f * most && inFloats < 2 * most) || !hasFloatDeterminant(placement))
            fail(pos,
                 "an object may be made larger by a factor of 1e12 at most; where its placement stretches it aslant, "
                 "into what is at most 1000 times as long as wide, or 1e6 times as wide as thick");
    }
}

std::shared_ptr<const TextureCost> costAbove(const TextureCost& others, const ParamSet& params) {
    const TextureCost cost{others.depth + 1, others.lookups + 1};
    if (cost.depth > limits::kTextureDepth)
        fail(params.pos(), params.owner() + " is made of textures of textures, " + std::to_string(cost.depth) +
                               " deep; at most " + std::to_string(limits::kTextureDepth) + " are looked up");
    if (cost.lookups > limits::kTextureLookups)
        fail(params.pos(), params.owner() + " would look up " + std::to_string(cost.lookups) +
                               " textures for each point, counting those of its parts; at most " +
                               std::to_string(limits::kTextureLookups) + " are looked up");
    return std::make_shared<const TextureCost>(cost);
}

bool isWithinReach(const Bounds& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(b.min[axis] > -limits::kCoordinate && b.min[axis] <= b.max[axis] && b.max[axis] < limits::kCoordinate))
            return false;
    return true;
}

void checkShared(const ParamSet& params, const std::string& target, const SourcePos& pos) {
    size_t values = 0;
    for (const Param& param : params.all()) values += param.numbers.size() + param.strings.size() + param.bools.size();
    if (params.all().size() > limits::kParameters || values > limits::kAttributeValues)
        fail(pos, fmt::format("the Attributes of each {} come to {} parameters with {} values; there may be {} with {}",
                              target, params.all().size(), values, limits::kParameters, limits::kAttributeValues));
}

}  // namespace drc::pbrt
