#include "scene/textures/texture_footprint.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TextureContext onPlane(const Vec3& dpdu, const Vec3& dpdv) {
    TextureContext at;
    at.dpdu = dpdu;
    at.dpdv = dpdv;
    return at;
}

TEST(Footprint, IsAsWideAsTheConeAcrossItAndStretchedAlongIt) {
    const Vec3 n(0, 0, 1), wo = normalize(Vec3(3, 0, 4));  // cosine 0.8
    TextureContext at = onPlane(Vec3(1, 0, 0), Vec3(0, 1, 0));
    setFootprint(at, 0.1f, n, wo);
    EXPECT_NEAR(std::abs(at.dpdx.y), 0.1f, 1e-6f);
    EXPECT_NEAR(length(at.dpdx), 0.1f, 1e-6f);
    EXPECT_NEAR(std::abs(at.dpdy.x), 0.1f / 0.8f, 1e-6f);
    EXPECT_NEAR(length(at.dpdy), 0.1f / 0.8f, 1e-6f);
}

TEST(Footprint, UvFollowsTheSurfacesDerivatives) {
    // Neither perpendicular nor of equal length.
    const Vec3 dpdu(2, 0.5f, 0), dpdv(-0.3f, 0.25f, 0);
    for (const Vec3& wo : {Vec3(0, 0, 1), normalize(Vec3(1, -2, 0.5f)), normalize(Vec3(-1, 0.1f, -1))}) {
        TextureContext at = onPlane(dpdu, dpdv);
        setFootprint(at, 0.02f, Vec3(0, 0, 1), wo);
        EXPECT_LT(length(dpdu * at.duvdx.x + dpdv * at.duvdx.y - at.dpdx), 1e-6f);
        EXPECT_LT(length(dpdu * at.duvdy.x + dpdv * at.duvdy.y - at.dpdy), 1e-6f);
        EXPECT_NEAR(at.uvFootprint, 0.02f / std::sqrt(length(cross(dpdu, dpdv))), 1e-6f);
        EXPECT_NEAR(dot(at.dpdx, at.dpdy), 0, 1e-7f);
    }
}

TEST(Footprint, IsBoundedAtTheHorizonAndZeroWithoutDerivatives) {
    TextureContext at = onPlane(Vec3(1, 0, 0), Vec3(0, 1, 0));
    setFootprint(at, 1, Vec3(0, 0, 1), Vec3(1, 0, 0));
    EXPECT_NEAR(length(at.dpdy), 16, 1e-4f);
    at = onPlane(Vec3(1, 0, 0), Vec3(2, 0, 0));
    setFootprint(at, 1, Vec3(0, 0, 1), Vec3(0, 0, 1));
    EXPECT_EQ(at.duvdx, Vec2(0, 0));
    EXPECT_EQ(at.uvFootprint, 0);
    EXPECT_NEAR(length(at.dpdx), 1, 1e-6f);
    setFootprint(at, 0, Vec3(0, 0, 1), Vec3(0, 0, 1));
    EXPECT_EQ(at.dpdx, Vec3(0.f));
}

}  // namespace
}  // namespace drc
