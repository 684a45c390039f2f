#include "scene/cameras/lens_system.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace drc {
namespace {

// A biconvex lens with radii of 100 mm, 10 mm thick, with the stop behind it.
std::vector<LensElement> biconvex(float aperture = 0.02f) {
    return {{0.1f, 0.01f, 1.5f, aperture}, {-0.1f, 0.002f, 1, aperture}, {0, 0.09f, 0, aperture}};
}

TEST(LensSystem, FocalLengthOfTheThickLens) {
    // Lensmaker's equation: 1/f = (n-1) (1/R1 - 1/R2 + (n-1) d / (n R1 R2)), R2 negative. The principal planes are f
    // (n-1) d / (n R) inside the vertices.
    const double f = 1 / (0.5 * (10 + 10 - 0.5 * 0.01 / (1.5 * 0.01)));
    const double inside = f * 0.5 * 0.01 / (1.5 * 0.1);
    const LensSystem lens(biconvex());
    const LensSystem::Cardinal c = lens.cardinal();
    EXPECT_NEAR(c.focalLength, f, 1e-6);
    EXPECT_NEAR(c.front, 0.102 - inside, 1e-6);
    EXPECT_NEAR(c.rear, 0.092 + inside, 1e-6);
    EXPECT_NEAR(lens.frontZ(), 0.102, 1e-6);
}

TEST(LensSystem, RaysMeetWhereItIsFocused) {
    for (const float distance : {0.5f, 2.f, 10.f}) {
        LensSystem lens(biconvex());
        lens.focus(distance);
        // Near the axis, where the paraxial approximation holds.
        const auto line = lens.trace({Vec3(0, 0, 0), Vec3(0.0005f, 0.0003f, lens.rearZ())});
        ASSERT_TRUE(line);
        const Vec3 at = line->o + line->d * ((distance - line->o.z) / line->d.z);
        EXPECT_LT(std::abs(at.x) + std::abs(at.y), 2e-4f * distance) << distance;
        EXPECT_GT(line->o.z, lens.rearZ());
    }
    LensSystem lens(biconvex());
    EXPECT_THROW(lens.focus(0.3f), Error);  // closer than four focal lengths
    LensSystem diverging({{-0.1f, 0.01f, 1.5f, 0.02f}, {0.1f, 0.09f, 1, 0.02f}});
    EXPECT_THROW(diverging.focus(10), Error);
}

TEST(LensSystem, ImagesAreUpsideDownAndOfTheRightSize) {
    LensSystem lens(biconvex(0.001f));
    lens.focus(2);
    const LensSystem::Cardinal c = lens.cardinal();
    const float height = 0.004f;
    const auto line = lens.trace({Vec3(height, 0, 0), Vec3(-height, 0, c.rear)});
    ASSERT_TRUE(line);
    const float x = line->o.x + line->d.x * ((2 - line->o.z) / line->d.z);
    EXPECT_NEAR(x, -height * (2 - c.front) / c.rear, 2e-3f * std::abs(x));
}

TEST(LensSystem, RimsAndTotalReflectionStopRays) {
    const LensSystem lens(biconvex(0.005f));
    EXPECT_TRUE(lens.trace({Vec3(0, 0, 0), Vec3(0.0045f, 0, lens.rearZ())}));
    EXPECT_FALSE(lens.trace({Vec3(0, 0, 0), Vec3(0.0051f, 0, lens.rearZ())}));
    EXPECT_FALSE(lens.trace({Vec3(0, 0, 0), Vec3(0, 0, -1)}));
    // A hemisphere with its flat side towards the film: beyond 42 degrees inside the glass, all light is totally
    // reflected.
    const LensSystem ball({{0.01f, 0.01f, 1.5f, 0.0099f}, {0, 0.001f, 1.5f, 0.0099f}});
    EXPECT_TRUE(ball.trace({Vec3(0.001f, 0, 0), Vec3(0, 0, 1)}));
    EXPECT_FALSE(ball.trace({Vec3(0.0095f, 0, 0), Vec3(0, 0, 1)}));
}

}  // namespace
}  // namespace drc
