#include "pbrt/instance_budget.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"
#include "pbrt/source.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const AnimatedTransform kSlide(Transform(), Transform::translate(Vec3(1, 0, 0)));

// Takes instances until there are too many, or until `most`. Returns their number and the error.
struct Taken {
    size_t count = 0;
    std::string error;
};
Taken takeAll(InstanceBudget& budget, const AnimatedTransform& motion, size_t most) {
    const auto source = Source::fromText("ObjectInstance \"o\"", "s.pbrt", ".");
    Taken taken;
    taken.error = errorOf([&] {
        for (; taken.count < most; ++taken.count) budget.take({0, motion}, {source.get(), 15});
    });
    return taken;
}

TEST(InstanceBudget, CountsTheMomentsOfAMotion) {
    const AnimatedTransform withinAnother = kSlide * kSlide;
    const std::pair<AnimatedTransform, size_t> cases[] = {
        {AnimatedTransform(), 1000}, {kSlide, 500}, {withinAnother, 15}};
    for (const auto& [motion, most] : cases) {
        InstanceBudget budget(1000);
        const Taken taken = takeAll(budget, motion, 2000);
        EXPECT_EQ(taken.count, most);
        EXPECT_THAT(taken.error, StartsWith("s.pbrt:1:16: with this one, instances count for more than 1000;"));
    }
}

TEST(InstanceBudget, HoldsTheMemoryOfAllOfThem) {
    const AnimatedTransform motion = kSlide * kSlide;
    InstanceBudget budget(std::numeric_limits<size_t>::max());
    const size_t most = size_t(double(availableMemory()) / Instance{0, motion}.memory());
    const Taken taken = takeAll(budget, motion, most);
    EXPECT_THAT(taken.error, AllOf(StartsWith("s.pbrt:1:16: placing "), HasSubstr(" of memory, and ")));
    // Claiming in advance must not refuse instances for which there is plenty of memory.
    EXPECT_GT(taken.count, most / 2);
}

}  // namespace
}  // namespace drc::pbrt
