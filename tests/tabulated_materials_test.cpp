// Materials that are tables give the pictures of what they are tables of.
#include "tabulated_materials.h"

#include <gtest/gtest.h>

#include "pipeline.h"

namespace drc {
namespace {

using test::Estimate;
using test::Pipeline;

class TabulatedMaterials : public testing::TestWithParam<test::TabulatedMaterial> {};
INSTANTIATE_TEST_SUITE_P(Every, TabulatedMaterials, testing::ValuesIn(test::kTabulatedMaterials),
                         [](const auto& i) { return i.param.name; });

TEST_P(TabulatedMaterials, LookLikeWhatTheyAreTablesOf) {
    const TemporaryFolder folder;
    constexpr int kSamples = 1024, kGroup = 16;
    const auto pictureOf = [&](const std::string& material) {
        const Pipeline pipeline(test::roomWith(GetParam(), material, 12, 10));
        return pipeline.estimate(&Pipeline::path, kSamples, kGroup);
    };
    const Estimate table = pictureOf(GetParam().write(folder)), same = pictureOf(GetParam().same);
    // What interpolation between the table's entries may cost.
    test::expectSame(test::allowing(0.005, table, same), same, GetParam().name);
    // Close enough to tell it from a material a little brighter.
    double mean = 0, variance = 0;
    for (size_t i = 0; i < same.mean.size(); ++i) {
        mean += same.mean[i];
        variance += same.variance[i] + table.variance[i];
    }
    EXPECT_LT(std::sqrt(variance), 0.01 * mean);
}

}  // namespace
}  // namespace drc
