#include "scene/textures/texture_mapping.h"

#include <gtest/gtest.h>

#include <random>

namespace drc {
namespace {

TextureContext contextAt(const Vec3& p) {
    TextureContext at;
    at.p = p;
    at.uv = Vec2(0.3f, 0.6f);
    return at;
}

TEST(Mapping2D, Uv) {
    TextureContext at = contextAt(Vec3(0.f));
    at.duvdx = Vec2(0.1f, 0);
    at.duvdy = Vec2(0.02f, 0.2f);
    const PlanePoint point = Mapping2D({2, 10, 0.25f, -1}).at(at);
    EXPECT_LT((point.st - Vec2(0.85f, 5)).length(), 1e-6f);
    EXPECT_EQ(point.dstdx, Vec2(0.2f, 0));
    EXPECT_EQ(point.dstdy, Vec2(0.04f, 2));
}

TEST(Mapping2D, Spherical) {
    const auto st = [](const Vec3& p) {
        // The texture's origin is at (1, 2, 3).
        return Mapping2D::spherical(Transform::translate(Vec3(1, 2, 3)).inverse()).at(contextAt(p + Vec3(1, 2, 3))).st;
    };
    EXPECT_LT((st(Vec3(0, 0, 5)) - Vec2(0, 0)).length(), 1e-6f);
    EXPECT_NEAR(st(Vec3(0, 0, -5)).x, 1, 1e-6f);
    EXPECT_LT((st(Vec3(4, 0, 0)) - Vec2(0.5f, 0)).length(), 1e-6f);
    EXPECT_LT((st(Vec3(0, 0.5f, 0)) - Vec2(0.5f, 0.25f)).length(), 1e-6f);
    EXPECT_LT((st(Vec3(0, -1, 1)) - Vec2(0.25f, 0.75f)).length(), 1e-6f);
}

TEST(Mapping2D, Cylindrical) {
    const Mapping2D mapping = Mapping2D::cylindrical(Transform::scale(2, 2, 2));
    const auto st = [&](const Vec3& p) { return mapping.at(contextAt(p)).st; };
    EXPECT_LT((st(Vec3(1, 0, 0)) - Vec2(0.5f, 0)).length(), 1e-6f);
    EXPECT_LT((st(Vec3(0, 1, 0)) - Vec2(0.75f, 0)).length(), 1e-6f);
    EXPECT_LT((st(Vec3(3, 0, 4)) - Vec2(0.5f, 0.8f)).length(), 1e-6f);
}

TEST(Mapping2D, Planar) {
    TextureContext at = contextAt(Vec3(1, 2, 3));
    at.dpdx = Vec3(0.1f, 0, 0);
    at.dpdy = Vec3(0, 0.1f, 0.1f);
    const PlanePoint point = Mapping2D::planar(Vec3(2, 0, 0), Vec3(0, 0, 0.5f), Vec2(0.1f, 0.2f)).at(at);
    EXPECT_LT((point.st - Vec2(2.1f, 1.7f)).length(), 1e-6f);
    EXPECT_LT((point.dstdx - Vec2(0.2f, 0)).length(), 1e-6f);
    EXPECT_LT((point.dstdy - Vec2(0, 0.05f)).length(), 1e-6f);
}

// Compares with finite differences of the mapping, except across the seam.
TEST(Mapping2D, ChangesAreDerivatives) {
    const Transform frame = Transform::rotate(40, Vec3(1, 2, 3)) * Transform::scale(1, 2, 0.5f);
    const Mapping2D mappings[] = {Mapping2D::spherical(frame), Mapping2D::cylindrical(frame),
                                  Mapping2D::planar(Vec3(1, 2, 3), Vec3(-1, 0, 2), Vec2(0, 0))};
    std::mt19937 rng(3);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (int i = 0; i < 50; ++i) {
        TextureContext at = contextAt(Vec3(uniform(rng), uniform(rng), uniform(rng)) * 2.f);
        at.dpdx = Vec3(uniform(rng), uniform(rng), uniform(rng)) * 1e-3f;
        at.dpdy = Vec3(uniform(rng), uniform(rng), uniform(rng)) * 1e-3f;
        const Vec3 local = frame.point(at.p);
        if (local.x * local.x + local.y * local.y < 0.1f) continue;
        for (const Mapping2D& mapping : mappings) {
            const PlanePoint point = mapping.at(at);
            for (const auto& [step, change] : {std::pair(at.dpdx, point.dstdx), std::pair(at.dpdy, point.dstdy)}) {
                const Vec2 difference =
                    (mapping.at(contextAt(at.p + step)).st - mapping.at(contextAt(at.p - step)).st) * 0.5f;
                if (difference.length() > 0.2f) continue;  // across the seam
                EXPECT_LT((difference - change).length(), 0.02f * change.length() + 2e-6f);
            }
        }
    }
}

TEST(Mapping2D, HasNoSeamAndStaysFiniteOnTheAxis) {
    // Near y = 0, where the azimuth jumps by a full turn.
    for (const Mapping2D& mapping : {Mapping2D::spherical({}), Mapping2D::cylindrical({})})
        for (const float side : {-1.f, 1.f}) {
            TextureContext at = contextAt(Vec3(side, -1e-5f, 0.1f));
            at.dpdx = Vec3(0, 1e-3f, 0);
            const PlanePoint point = mapping.at(at);
            EXPECT_LT(point.dstdx.length(), 1e-3f);
            EXPECT_GT(point.dstdx.length(), 1e-4f);
            at.p = Vec3(0, 0, 1);
            EXPECT_TRUE(std::isfinite(mapping.at(at).dstdx.length()));
            at.p = Vec3(0.f);
            EXPECT_TRUE(std::isfinite(mapping.at(at).dstdx.length() + mapping.at(at).st.length()));
        }
}

TEST(Mapping3D, TakesPointsAndChangesToTheTexture) {
    TextureContext at = contextAt(Vec3(2, 3, 4));
    at.dpdx = Vec3(1, 0, 0);
    at.dpdy = Vec3(0, 0, 1);
    const SolidPoint point = Mapping3D(Transform::translate(Vec3(1, 1, 1)) * Transform::scale(2, 2, 3)).at(at);
    EXPECT_EQ(point.p, Vec3(5, 7, 13));
    EXPECT_EQ(point.dpdx, Vec3(2, 0, 0));
    EXPECT_EQ(point.dpdy, Vec3(0, 0, 3));
}

}  // namespace
}  // namespace drc
