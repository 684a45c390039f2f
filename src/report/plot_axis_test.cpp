#include "report/plot_axis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace drc {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

auto near(double x) { return DoubleNear(x, 1e-9 * x); }

TEST(PlotAxis, LogarithmicEndsAreRoundAndClose) {
    const PlotAxis axis = logarithmicAxis(0.023, 0.41);
    EXPECT_TRUE(axis.logarithmic);
    EXPECT_THAT(axis.low, near(0.02));
    EXPECT_THAT(axis.high, near(0.5));
    EXPECT_THAT(axis.ticks, ElementsAre(near(0.02), near(0.05), near(0.1), near(0.2), near(0.5)));
    EXPECT_NEAR(axis.place(0.1), 0.5, 1e-12);
}

TEST(PlotAxis, LogarithmicTicksThinOutOverDecades) {
    EXPECT_THAT(logarithmicAxis(0.003, 4).ticks, ElementsAre(near(0.01), near(0.1), near(1)));
    EXPECT_THAT(logarithmicAxis(1.5e-5, 30).low, near(1e-5));
    EXPECT_LE(logarithmicAxis(1e-12, 1e9).ticks.size(), 8u);
}

TEST(PlotAxis, LogarithmicOfOneValueHasAWidth) {
    for (const double value : {1.0, 2.0, 3.0, 5.0, 0.07}) {
        const PlotAxis axis = logarithmicAxis(value, value);
        EXPECT_LT(axis.low, axis.high) << value;
        EXPECT_LE(axis.low, value * (1 + 1e-9));
        EXPECT_GE(axis.high, value * (1 - 1e-9));
    }
}

TEST(PlotAxis, TicksAreShort) {
    EXPECT_EQ(tickText(0), "0");
    EXPECT_EQ(tickText(0.001), "0.001");
    EXPECT_EQ(tickText(0.05), "0.05");
    EXPECT_EQ(tickText(1000), "1000");
    EXPECT_EQ(tickText(1e-5), "10\u207b\u2075");
    EXPECT_EQ(tickText(2e-12 * 10), "2\u00b710\u207b\u00b9\u00b9");
    EXPECT_EQ(tickText(5e6), "5\u00b710\u2076");
}

}  // namespace
}  // namespace drc
