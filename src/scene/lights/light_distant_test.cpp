#include <gtest/gtest.h>

#include "scene/lights/light.h"

namespace drc {
namespace {

TEST(DistantLight, SameEverywhere) {
    const LightPtr light = makeDistantLight(Vec3(0, 3, 4), Rgb(2, 1, 0));
    const auto s = light->sample(Vec3(10, 20, 30), Vec2(0, 0));
    ASSERT_TRUE(s);
    EXPECT_NEAR(length(s->wi - Vec3(0, 0.6f, 0.8f)), 0, 1e-6);
    EXPECT_EQ(s->radiance, Rgb(2, 1, 0));
    EXPECT_EQ(s->distance, kInfinity);
    EXPECT_TRUE(s->delta && light->isDelta());
    EXPECT_NEAR(light->power(3).x, 18 * kPi, 1e-4);
    EXPECT_TRUE(light->bounds().empty());
}

}  // namespace
}  // namespace drc
