#include "scene/lights/facet.h"

#include <gtest/gtest.h>

#include "math/rng.h"
#include "scene/lights/facet_grids.h"

namespace drc {
namespace {

// A parallelogram of two triangles, whose corners are listed in different orders.
TriangleMesh quad() {
    TriangleMesh m;
    m.positions = {Vec3(1, 0, 2), Vec3(3, 1, 2), Vec3(4, 3, 5), Vec3(2, 2, 5)};
    m.indices = {1, 2, 0, 2, 3, 0};
    return m;
}

TEST(Facet, SquareAndPointAreInverse) {
    Pcg32 rng(1);
    for (const bool half : {false, true}) {
        Vec2 mean(0, 0);
        for (int i = 0; i < 20000; ++i) {
            const Vec2 u = rng.nextVec2(), xy = pointOnFacet(u, half);
            EXPECT_LT((squareOfFacet(xy, half) - u).length(), 1e-5f);
            if (half) {
                EXPECT_LE(xy.x + xy.y, 1.000001f);
            }
            mean += xy * (1 / 20000.f);
        }
        // Uniform: the mean is the centre.
        EXPECT_LT((mean - Vec2(half ? 1 / 3.f : 0.5f)).length(), 0.01f);
    }
}

TEST(Facet, CoordinatesAreThoseOfThePoint) {
    std::vector<uint32_t> facetOf;
    const TriangleMesh m = quad();
    const std::vector<Facet> facets = joinedFacets(m, false, facetOf);
    ASSERT_EQ(facets.size(), 1U);
    EXPECT_EQ(facetOf, (std::vector<uint32_t>{0, 0}));
    EXPECT_NEAR(facets[0].area, m.area(0) + m.area(1), 1e-6f);
    Pcg32 rng(1);
    for (int i = 0; i < 100; ++i) {
        const Vec2 xy = rng.nextVec2();
        EXPECT_LT((facets[0].coordinatesOf(facets[0].at(xy)) - xy).length(), 1e-5f);
    }
}

TEST(Facet, AnImageThatDoesNotContinueKeepsTrianglesApart) {
    std::vector<uint32_t> facetOf;
    TriangleMesh m = quad();
    m.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    const std::vector<Facet> whole = joinedFacets(m, true, facetOf);
    ASSERT_EQ(whole.size(), 1U);
    // The image at each corner of the parallelogram is that of the vertex there.
    const FacetCoordinates on = coordinatesOn(whole[0], m);
    for (size_t i = 0; i < 4; ++i)
        EXPECT_LT((on.at(whole[0].coordinatesOf(m.positions[i])) - m.uvs[i]).length(), 1e-5f) << i;
    m.uvs[3] = Vec2(0.1f, 1);
    EXPECT_EQ(joinedFacets(m, true, facetOf).size(), 2U);
    EXPECT_EQ(facetOf, (std::vector<uint32_t>{0, 1}));
    EXPECT_EQ(joinedFacets(m, false, facetOf).size(), 1U);
    // Without coordinates, each triangle has pbrt's own.
    m.uvs.clear();
    EXPECT_EQ(joinedFacets(m, true, facetOf).size(), 2U);
}

LightImage checks(int side) {
    LightImage image{side, side, {}};
    for (int i = 0; i < side * side; ++i) image.texels.push_back(Rgb((i % side / 4 + i / side / 4) % 2 ? 1.f : 0.1f));
    return image;
}

TEST(FacetGrids, AreSharedByEqualCoordinates) {
    const EmissionImage image(checks(32));
    const FacetCoordinates a{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), false};
    const FacetEmission first = image.facetGrids().of(image, a), again = image.facetGrids().of(image, a);
    ASSERT_TRUE(first.grid);
    EXPECT_EQ(first.grid, again.grid);
    EXPECT_NEAR(first.mean.x, 0.55f, 1e-3f);
    FacetCoordinates half = a;
    half.half = true;
    EXPECT_NE(image.facetGrids().of(image, half).grid, first.grid);
    // A facet that shows less than a pixel.
    EXPECT_FALSE(image.facetGrids().of(image, {Vec2(0.3f, 0.3f), Vec2(0.01f, 0), Vec2(0, 0.01f), true}).grid);
}

TEST(FacetGrids, TogetherAreBounded) {
    const EmissionImage image(checks(256));
    int first = 0, last = 0;
    for (int i = 0; i < 400; ++i) {
        const auto shown = image.facetGrids().of(image, {Vec2(0, 0), Vec2(1 - 1e-4f * float(i), 0), Vec2(0, 1), false});
        last = shown.grid ? shown.grid->cellCount() : 1;
        if (i == 0) first = last;
    }
    EXPECT_GT(first, 1000);
    EXPECT_LE(last, 256);
}

TEST(FacetGrids, CoordinatesMayBeAnything) {
    const EmissionImage image(checks(8));
    for (const float x : {NAN, kInfinity, 1e30f}) {
        const auto shown = image.facetGrids().of(image, {Vec2(x, 0), Vec2(1, x), Vec2(0, 1), true});
        EXPECT_TRUE(isFinite(shown.mean));
        EXPECT_TRUE(std::isfinite(shown.weight));
    }
}

}  // namespace
}  // namespace drc
