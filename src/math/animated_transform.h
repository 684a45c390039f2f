// A transform that is interpolated between one at time 0 and another at time 1 (PBR 3e, section 2.9).
#pragma once
#include <memory>

#include "math/transform.h"

namespace drc {

// Both ends are decomposed into translation, rotation and stretch (polar decomposition), which are interpolated
// separately, so that rotating objects do not shrink on the way; the rotation follows the shorter arc. Times are
// clamped to [0, 1]. If both ends mirror, so does every transform in between.
class AnimatedTransform {
  public:
    AnimatedTransform() = default;
    // A transform that stands still converts implicitly, since anything that may move may also stand still. It costs no
    // more than a Transform.
    AnimatedTransform(const Transform& still) : start_(still) {}  // NOLINT(google-explicit-constructor)
    // Stands still if both ends are the same.
    AnimatedTransform(const Transform& start, const Transform& end);

    bool isAnimated() const { return motion_ != nullptr; }
    const Transform& start() const { return start_; }
    const Transform& end() const;
    Transform at(float time) const;
    // At every time t, at(t) is the product of a.at(t) and b.at(t), which differs from the interpolation between the
    // products at both ends.
    friend AnimatedTransform operator*(const AnimatedTransform& a, const AnimatedTransform& b);
    // Interpolates between the inverses of both ends, as pbrt does for a camera. This is not the inverse of at(t)
    // between the ends.
    AnimatedTransform inverse() const { return {start_.inverse(), end().inverse()}; }

    // Number of equally spaced times, both ends included, at which to sample the motion for Embree: 1 if the transform
    // stands still; 2 if it is a single interpolation that stretches along the coordinate axes, which Embree can
    // reproduce; otherwise, as for a product of motions, kMostSteps. With kMostSteps, half a turn composed with another
    // half turn deviates by less than a thousandth of its radius.
    static constexpr unsigned kMostSteps = 65;
    unsigned steps() const;

  private:
    struct Motion;

    Transform start_;
    std::shared_ptr<const Motion> motion_;  // null if it stands still
};

}  // namespace drc
