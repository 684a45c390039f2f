#include "pbrt/instance_budget.h"

#include <fmt/core.h>

namespace drc::pbrt {

void InstanceBudget::take(const Instance& instance, const SourcePos& pos) {
    taken_ += instance.objectToWorld.steps();
    if (taken_ > steps_)
        fail(pos,
             fmt::format("with this one, instances count for more than {}; one that moves counts for up to {}, and "
                         "each part that moves within an object is an instance of its own",
                         steps_, AnimatedTransform::kMostSteps));
    bytes_ += instance.memory();
    if (bytes_ <= claimed_) return;
    // Claims a quarter more in advance, because asking the system takes longer than placing an instance.
    claimed_ = 1.25 * bytes_;
    memory_.reset();
    try {
        memory_.emplace(claimed_,
                        fmt::format("placing {:.3g} instances and the moments of their motion", double(taken_)));
    } catch (const Error& error) {
        fail(pos, error.what());
    }
}

}  // namespace drc::pbrt
