// Counts instances against the limits in limits.h.
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

    // To be called before an instance is stored. Throws Error at pos if there are too many, or if memory does not
    // suffice for all of them; the memory stays claimed.
    void take(const Instance& instance, const SourcePos& pos);

  private:
    size_t steps_, taken_ = 0;
    double bytes_ = 0, claimed_ = 0;
    std::optional<MemoryClaim> memory_;
};

}  // namespace drc::pbrt
