// Counts a scene's instances against the limits in limits.h.
#pragma once
#include <optional>

#include "base/limits.h"
#include "base/memory.h"
#include "pbrt/source.h"
#include "scene/scene.h"

namespace drc::pbrt {

class InstanceBudget {
  public:
    explicit InstanceBudget(size_t steps = limits::kInstanceSteps) : steps_(steps) {}

    // Call this before storing an instance. Throws Error at pos if there are too many instances, or not enough memory
    // for all of them. The memory stays claimed.
    void take(const Instance& instance, const SourcePos& pos);

  private:
    size_t steps_, taken_ = 0;
    double bytes_ = 0, claimed_ = 0;
    std::optional<MemoryClaim> memory_;
};

}  // namespace drc::pbrt
