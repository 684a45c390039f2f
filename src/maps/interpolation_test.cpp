#include "maps/interpolation.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

// A map on the plane z = 0 that sees surfaces at the same distance, 10 by default, in all directions.
MapSite siteAt(const Vec3& p, const Vec3& n, float seen = 10) {
    const MapLayout layout(Projection::EqualArea, 8);
    CapturedMap map;
    map.origin = p;
    map.frame = Frame::fromNormal(n);
    map.radiance.assign(3 * 64, 1.f);
    map.normal.assign(3 * 64, 0.f);
    map.distance.assign(64, seen);
    MapSite site;
    site.p = p;
    site.n = n;
    site.film = Vec2(50, 50);
    site.radius = 20;
    site.front = RadianceMap(map, layout);
    site.hasFront = true;
    return site;
}

PixelSite pixelAt(const Vec3& p, const Vec3& n) {
    PixelSite pixel;
    pixel.p = p;
    pixel.n = n;
    pixel.film = Vec2(50, 50);
    pixel.pixelSize = 0.01f;
    return pixel;
}

const Vec3 kUp(0, 0, 1);

TEST(Interpolation, WeightIsLargestAtTheMapAndZeroAtTheCellsEdge) {
    EXPECT_FLOAT_EQ(tentWeight(Vec2(50, 50), Vec2(50, 50), 20), 1);
    EXPECT_FLOAT_EQ(tentWeight(Vec2(60, 50), Vec2(50, 50), 20), 0.5f);
    EXPECT_FLOAT_EQ(tentWeight(Vec2(70, 50), Vec2(50, 50), 20), 0);
    EXPECT_FLOAT_EQ(tentWeight(Vec2(90, 50), Vec2(50, 50), 20), 0);
    EXPECT_FLOAT_EQ(radialWeight(Vec2(50, 60), Vec2(50, 50), 20), 0.5f);
    EXPECT_FLOAT_EQ(radialWeight(Vec2(50, 70), Vec2(50, 50), 20), 0);
}

TEST(Interpolation, TheTentsOfACellSumToOne) {
    for (float x = 0; x < 20; x += 3.7f)
        for (float y = 0; y < 20; y += 2.9f) {
            float sum = 0;
            for (const Vec2& corner : {Vec2(0, 0), Vec2(20, 0), Vec2(0, 20), Vec2(20, 20)})
                sum += tentWeight(Vec2(x, y), corner, 20);
            EXPECT_NEAR(sum, 1, 1e-5f);
        }
}

TEST(Interpolation, SamePointSameNormalCountsInFull) {
    EXPECT_FLOAT_EQ(geometryWeight(pixelAt(Vec3(0, 0, 0), kUp), siteAt(Vec3(0, 0, 0), kUp)), 1);
}

TEST(Interpolation, NormalsAtRightAnglesOrMoreDoNotCount) {
    const Vec3 o(0, 0, 0);
    EXPECT_EQ(geometryWeight(pixelAt(o, kUp), siteAt(o, Vec3(1, 0, 0))), 0);
    EXPECT_EQ(geometryWeight(pixelAt(o, kUp), siteAt(o, -kUp)), 0);
    const float near = geometryWeight(pixelAt(o, kUp), siteAt(o, normalize(Vec3(0.2f, 0, 1))));
    const float far = geometryWeight(pixelAt(o, kUp), siteAt(o, normalize(Vec3(1, 0, 1))));
    EXPECT_GT(near, far);
    EXPECT_GT(far, 0);
}

TEST(Interpolation, AMapBehindADepthEdgeDoesNotCount) {
    const PixelSite pixel = pixelAt(Vec3(0, 0, 0), kUp);
    EXPECT_EQ(geometryWeight(pixel, siteAt(Vec3(0.05f, 0, 0.11f), kUp)), 0);  // half the radius: 10 pixels of 0.01
    EXPECT_EQ(geometryWeight(pixel, siteAt(Vec3(0.05f, 0, -0.11f), kUp)), 0);
    EXPECT_GT(geometryWeight(pixel, siteAt(Vec3(0.05f, 0, 0.03f), kUp)), 0.5f);
    EXPECT_GT(geometryWeight(pixel, siteAt(Vec3(0.5f, 0, 0), kUp)), 0.9f) << "far along the plane is no edge";
}

TEST(Interpolation, RelaxedWeightsFadeOffThePlaneButKeepTheSides) {
    const PixelSite pixel = pixelAt(Vec3(0, 0, 0), kUp);
    const float near = relaxedWeight(pixel, siteAt(Vec3(0, 0, 0.11f), kUp));
    const float far = relaxedWeight(pixel, siteAt(Vec3(0, 0, 0.5f), kUp));
    EXPECT_GT(near, far);
    EXPECT_GT(far, 0);
    EXPECT_EQ(relaxedWeight(pixel, siteAt(Vec3(0, 0, 0), -kUp)), 0);
}

TEST(Interpolation, AMapInACornerReachesLessFar) {
    const PixelSite pixel = pixelAt(Vec3(0, 0, 0), kUp);
    EXPECT_LT(geometryWeight(pixel, siteAt(Vec3(0.2f, 0, 0), kUp, 0.1f)),
              0.2f * geometryWeight(pixel, siteAt(Vec3(0.2f, 0, 0), kUp, 10)));
}

TEST(Interpolation, ByDistanceAloneWhateverIsThereCounts) {
    PixelSite pixel = pixelAt(Vec3(0, 0, 0), kUp);
    MapSite site = siteAt(Vec3(0, 0, 5), Vec3(1, 0, 0), 0.1f);
    EXPECT_EQ(presentWeight(pixel, site), 1);
    pixel.transmits = true;
    EXPECT_EQ(presentWeight(pixel, site), 0);
    site.hasBack = true;
    EXPECT_EQ(presentWeight(pixel, site), 1);
    site.hasFront = false;
    EXPECT_EQ(presentWeight(pixel, site), 0);
}

TEST(Interpolation, AMissingMapOrSideHasNoWeight) {
    PixelSite pixel = pixelAt(Vec3(0, 0, 0), kUp);
    MapSite site = siteAt(Vec3(0, 0, 0), kUp);
    pixel.transmits = true;
    EXPECT_EQ(geometryWeight(pixel, site), 0);
    site.hasBack = true;
    EXPECT_GT(geometryWeight(pixel, site), 0);
    site.hasFront = false;
    EXPECT_EQ(geometryWeight(pixel, site), 0);
}

}  // namespace
}  // namespace drc
