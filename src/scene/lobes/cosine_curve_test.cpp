#include "scene/lobes/cosine_curve.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(CosineCurve, MeanOfConstantsAndOfTheInterpolant) {
    EXPECT_NEAR(CosineCurve(0.3f).mean(), 0.3f, 1e-6f);
    // The root of the cosine is linear in the nodes' coordinate: 2 times the integral of c^1.5 is 4/5.
    CosineCurve root;
    for (int i = 0; i < CosineCurve::kNodes; ++i) root[i] = std::sqrt(CosineCurve::cosineOf(i));
    EXPECT_NEAR(root.mean(), 0.8f, 1e-6f);
    // A bump, against the sum over many cosines.
    CosineCurve bump(0);
    bump[11] = 1;
    double sum = 0;
    constexpr int kSteps = 100000;
    for (int i = 0; i < kSteps; ++i) {
        const float c = (float(i) + 0.5f) / kSteps;
        sum += 2.0 * c * bump.at(c) / kSteps;
    }
    EXPECT_NEAR(bump.mean(), sum, 1e-6);
}

TEST(CosineCurve, IsLinearInTheRootOfTheCosineOnBothSides) {
    CosineCurve root;
    for (int i = 0; i < CosineCurve::kNodes; ++i) root[i] = std::sqrt(CosineCurve::cosineOf(i));
    for (const float c : {0.f, 1e-5f, 0.2f, 0.77f, 1.f}) {
        EXPECT_NEAR(root.at(c), std::sqrt(c), 1e-6f);
        EXPECT_EQ(root.at(-c), root.at(c));
    }
    EXPECT_NEAR(root.at(1.0001f), 1, 1e-6f);  // rounding of unit vectors
}

}  // namespace
}  // namespace drc
