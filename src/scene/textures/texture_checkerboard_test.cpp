#include "scene/textures/texture_checkerboard.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

FloatTexturePtr number(float x) { return constantTexture(x); }

TEST(Checkerboard, Alternates) {
    for (const CheckerboardEdges edges : {CheckerboardEdges::Sharp, CheckerboardEdges::Averaged}) {
        const auto at = [&](float u, float v, const UvMapping& mapping) {
            TextureContext context;
            context.uv = Vec2(u, v);
            return makeCheckerboardTexture<float>(number(1), number(0), mapping, edges)->eval(context);
        };
        EXPECT_EQ(at(0.5f, 0.5f, {}), 1);
        EXPECT_EQ(at(1.5f, 0.5f, {}), 0);
        EXPECT_EQ(at(1.5f, 1.5f, {}), 1);
        EXPECT_EQ(at(-0.5f, 0.5f, {}), 0);
        EXPECT_EQ(at(-0.5f, -0.5f, {}), 1);
        EXPECT_EQ(at(0.15f, 0.05f, {10, 10, 0, 0}), 0);
        EXPECT_EQ(at(0.15f, 0.05f, {10, 10, 1, 0}), 1);
    }
}

// Compares with the mean of many point-sampled lookups over the same box.
TEST(Checkerboard, AveragesItsFootprint) {
    const auto sharp = makeCheckerboardTexture<float>(number(1), number(0), UvMapping{}, CheckerboardEdges::Sharp);
    const auto averaged =
        makeCheckerboardTexture<float>(number(1), number(0), UvMapping{}, CheckerboardEdges::Averaged);
    for (const Vec2& uv : {Vec2(0.95f, 0.5f), Vec2(-0.1f, 2.02f), Vec2(3.4f, -5.9f), Vec2(1, 1)})
        for (const Vec2& width : {Vec2(0.2f, 0.1f), Vec2(0.7f, 1.5f), Vec2(1.9f, 0.3f), Vec2(0, 0.5f)}) {
            TextureContext at;
            at.uv = uv;
            at.duvdx = Vec2(width.x, 0);
            at.duvdy = Vec2(-width.x / 2, -width.y);
            float mean = 0;
            const int n = 200;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    TextureContext inside;
                    inside.uv = uv + width * Vec2((float(i) + 0.5f) / n - 0.5f, (float(j) + 0.5f) / n - 0.5f);
                    mean += sharp->eval(inside) / float(n * n);
                }
            EXPECT_NEAR(averaged->eval(at), mean, 0.02f) << uv << width;
        }
    TextureContext far;
    far.uv = Vec2(0.3f, 0.2f);
    far.duvdx = Vec2(30, 0);
    far.duvdy = Vec2(0, 20);
    EXPECT_EQ(averaged->eval(far), 0.5f);
}

TEST(Checkerboard, Solid) {
    const auto board =
        makeSolidCheckerboardTexture<float>(number(1), number(0), Mapping3D(Transform::translate(Vec3(1, 0, 0))));
    const auto at = [&](const Vec3& p) {
        TextureContext context;
        context.p = p;
        return board->eval(context);
    };
    EXPECT_EQ(at(Vec3(-0.5f, 0.5f, 0.5f)), 1);
    EXPECT_EQ(at(Vec3(0.5f, 0.5f, 0.5f)), 0);
    EXPECT_EQ(at(Vec3(0.5f, 0.5f, 1.5f)), 1);
    EXPECT_EQ(at(Vec3(0.5f, -0.5f, -0.5f)), 0);
}

TEST(Checkerboard, OfEqualConstantsIsConstant) {
    EXPECT_TRUE(
        makeCheckerboardTexture<float>(number(1), number(1), UvMapping{}, CheckerboardEdges::Sharp)->isConstant());
    EXPECT_FALSE(makeSolidCheckerboardTexture<float>(number(1), number(0), Mapping3D())->isConstant());
}

}  // namespace
}  // namespace drc
