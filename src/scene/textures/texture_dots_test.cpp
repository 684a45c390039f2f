#include "scene/textures/texture_dots.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(Dots, ManySquaresHaveOneThatLiesInside) {
    const auto dots = makeDotsTexture<float>(constantTexture(1.f), constantTexture(0.f), UvMapping{});
    const auto at = [&](float s, float t) {
        TextureContext context;
        context.uv = Vec2(s, t);
        return dots->eval(context);
    };
    const int squares = 24, n = 20;
    int withDot = 0;
    for (int j = 0; j < squares; ++j)
        for (int i = 0; i < squares; ++i) {
            double area = 0;
            Vec2 centre(0, 0);
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    const Vec2 st(float(i) - 0.5f + (float(x) + 0.5f) / n, float(j) - 0.5f + (float(y) + 0.5f) / n);
                    if (at(st.x, st.y) == 0) continue;
                    area += 1.0 / (n * n);
                    centre += st * (1.f / (n * n));
                }
            if (area == 0) continue;
            ++withDot;
            EXPECT_NEAR(area, kPi * 0.35 * 0.35, 0.03);  // no dot is cut off at the edge of its square
            EXPECT_LT(std::abs(centre.x / float(area) - float(i)), 0.16f);
        }
    // Squares where the noise is positive have dots: less than half, since it is zero in some.
    EXPECT_NEAR(withDot / double(squares * squares), 0.4, 0.05);
}

TEST(Dots, ShowBothTexturesAndFoldIfTheyAreTheSame) {
    EXPECT_TRUE(
        makeDotsTexture<Rgb>(constantTexture(Rgb(1, 2, 3)), constantTexture(Rgb(1, 2, 3)), UvMapping{})->isConstant());
    EXPECT_FALSE(
        makeDotsTexture<Rgb>(constantTexture(Rgb(1, 2, 3)), constantTexture(Rgb(0.f)), UvMapping{})->isConstant());
}

}  // namespace
}  // namespace drc
