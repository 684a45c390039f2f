// A transformation that changes with time, from one at time 0 to another at time 1 (PBR 3e, section 2.9).
#pragma once
#include <memory>

#include "math/transform.h"

namespace drc {

// Between its ends translation, rotation (along the shorter way) and what remains, which is stretch, are interpolated
// apart from each other, so that things turn without shrinking. Before and after, the ends hold. What mirrors at both
// ends mirrors all the time.
class AnimatedTransform {
  public:
    AnimatedTransform() = default;
    // One that stands still: anything that can move can do that. Costs no more than the transformation itself.
    AnimatedTransform(const Transform& still) : start_(still) {}  // NOLINT(google-explicit-constructor)
    // Stands still if both are the same.
    AnimatedTransform(const Transform& start, const Transform& end);

    bool isAnimated() const { return motion_ != nullptr; }
    const Transform& start() const { return start_; }
    const Transform& end() const;
    Transform at(float time) const;
    // a * b is at all times what both are then, one after the other: it is not interpolated from its own ends.
    friend AnimatedTransform operator*(const AnimatedTransform& a, const AnimatedTransform& b);
    // From the inverse of one end to that of the other, interpolated anew: what pbrt makes of a camera's.
    AnimatedTransform inverse() const { return {start_.inverse(), end().inverse()}; }

    // Moments, from the start to the end in equal steps, that stand for the motion where translation, rotation and
    // stretch along the axes of its own space are interpolated between them: 1 if it stands still, 2 if it is such an
    // interpolation itself, or kMostSteps. Half a turn of half a turn strays from itself by less than a thousandth of
    // its radius between those.
    static constexpr unsigned kMostSteps = 65;
    unsigned steps() const;

  private:
    struct Motion;

    Transform start_;
    std::shared_ptr<const Motion> motion_;  // null: stands still
};

}  // namespace drc
