#include "pbrt/scene_limits.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/limits.h"

namespace drc::pbrt {

namespace {

// Factor by which t makes things larger along one of the axes, or turns one of them into another.
float largest(const Transform& t) {
    float most = 0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) most = std::max(most, std::abs(t.at(row, column)));
    return most;
}

}  // namespace

bool isUsable(const Transform& t) {
    const Transform inverse = t.inverse();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            if (!std::isfinite(t.at(row, column)) || !std::isfinite(inverse.at(row, column))) return false;
    return t.isInvertible();
}

bool isInstanceable(const Transform& objectToWorld) {
    const Transform inverse = objectToWorld.inverse();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            if (!(std::abs(inverse.at(row, column)) <= limits::kInstanceScale)) return false;
    return true;
}

bool isMovable(const AnimatedTransform& objectToWorld) {
    constexpr int kMoments = 9;  // stretch is interpolated linearly
    for (int i = 0; i < kMoments; ++i) {
        const Transform t = objectToWorld.at(float(i) / (kMoments - 1));
        if (!isInstanceable(t) || !(largest(t) * largest(t.inverse()) <= limits::kMovingStretch)) return false;
    }
    return true;
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
