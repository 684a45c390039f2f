// How many instances a file may still ask for: see limits.h.
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

    // Before the instance is kept. Throws Error, at pos, if it is one too many, or if there is not the memory for all
    // of them: that is held back from then on.
    void take(const Instance& instance, const SourcePos& pos);

  private:
    size_t steps_, taken_ = 0;
    double bytes_ = 0, claimed_ = 0;
    std::optional<MemoryClaim> memory_;
};

}  // namespace drc::pbrt
