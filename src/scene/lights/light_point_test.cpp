#include <gtest/gtest.h>

#include "scene/lights/light.h"

namespace drc {
namespace {

TEST(PointLight, InverseSquare) {
    const LightPtr light = makePointLight(Vec3(0, 0, 4), Rgb(8, 4, 2));
    const auto s = light->sample(Vec3(0, 0, 2), Vec2(0.3f, 0.7f));
    ASSERT_TRUE(s);
    EXPECT_EQ(s->wi, Vec3(0, 0, 1));
    EXPECT_EQ(s->radiance, Rgb(2, 1, 0.5f));
    EXPECT_EQ(s->pdf, 1);
    EXPECT_EQ(s->distance, 2);
    EXPECT_TRUE(s->delta && light->isDelta());
    EXPECT_FALSE(light->isInfinite());
    EXPECT_NEAR(light->power(100).x, 32 * kPi, 1e-4);
    EXPECT_EQ(light->bounds().center(), Vec3(0, 0, 4));
    EXPECT_FALSE(light->sample(Vec3(0, 0, 4), Vec2(0, 0)));
}

}  // namespace
}  // namespace drc
