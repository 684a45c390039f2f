#include "app/map_pictures.h"

#include <gtest/gtest.h>

#include "image/color.h"
#include "maps/example_testing.h"
#include "maps/map_evaluation.h"

namespace drc {
namespace {

const MapLayout kLayout(Projection::EqualArea, 16);

TEST(MapPictures, ErrorsOfTexelsMakeTheL1) {
    const std::vector<float> a = randomLight(768, 1), b = randomLight(768, 2);
    const std::vector<float> errors = texelErrors(a, b, float(hemisphereMean(b, kLayout)));
    ASSERT_EQ(errors.size(), 256u);
    double sum = 0;
    for (const float e : errors) sum += e / 256;
    EXPECT_NEAR(sum, scoreMap(a, b, kLayout).l1, 1e-5);
}

TEST(MapPictures, RadianceIsExposedAndClipped) {
    std::vector<float> radiance(768, 0.25f);
    radiance[17] = 10;  // red of column 1, row 1
    const Image picture = radiancePicture(radiance, kLayout, 2);
    EXPECT_EQ(picture.rgb(0, 0), Rgb(0.5f));
    EXPECT_EQ(picture.rgb(1, 1), Rgb(1, 0.5f, 0.5f));
}

TEST(MapPictures, DistancesRunFromDarkToWhiteAndEscapesAreBlue) {
    CapturedMap map;
    map.distance.assign(256, 2);
    map.distance[1] = 8;
    map.distance[2] = 4;
    map.distance[3] = -1;
    const Image picture = distancePicture(map, kLayout);
    const Rgb near = picture.rgb(0, 0), far = picture.rgb(1, 0), between = picture.rgb(2, 0),
              escaped = picture.rgb(3, 0);
    EXPECT_NEAR(far.x, 1, 1e-5);
    EXPECT_LT(near.x, 0.02f);
    EXPECT_NEAR(srgbEncode(between.x), 0.5f * (srgbEncode(near.x) + srgbEncode(far.x)), 1e-4);
    EXPECT_GT(escaped.z, 2 * escaped.x);
    map.distance.assign(256, -1);
    EXPECT_EQ(distancePicture(map, kLayout).rgb(5, 5), escaped);
}

TEST(MapPictures, NormalsAreColours) {
    CapturedMap map;
    map.normal.assign(768, 0);
    map.normal[512] = 1;  // z of the first texel
    const Image picture = normalPicture(map, kLayout);
    EXPECT_NEAR(srgbEncode(picture.rgb(0, 0).x), 0.5, 1e-5);
    EXPECT_NEAR(picture.rgb(0, 0).z, 1, 1e-6);
    EXPECT_EQ(picture.rgb(1, 0), Rgb(0.f));
}

TEST(MapPictures, FalseColoursGetBrighterAndEndAtWhite) {
    const Image scale = errorScale();
    for (int x = 1; x < 256; ++x) EXPECT_GE(luminance(scale.rgb(x, 0)), luminance(scale.rgb(x - 1, 0))) << x;
    std::vector<float> errors(256, 3);
    errors[1] = 30;
    errors[2] = 0;
    const Image picture = errorPicture(errors, kLayout, 3);
    EXPECT_EQ(picture.rgb(0, 0), scale.rgb(255, 0));
    EXPECT_EQ(picture.rgb(1, 0), scale.rgb(255, 0));
    EXPECT_EQ(picture.rgb(2, 0), scale.rgb(0, 0));
}

}  // namespace
}  // namespace drc
