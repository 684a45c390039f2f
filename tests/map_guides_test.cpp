// The auxiliary channels of a map: albedo and direct light of the surfaces that it sees.
#include <gtest/gtest.h>

#include "maps/map_capture.h"
#include "pipeline.h"
#include "test_scenes.h"

namespace drc::test {
namespace {

// How far above the point on the floor the rays of a map start.
constexpr float kError = 1e-5f;

// Under a uniform white sky, the radiance of an isolated convex body equals its albedo. The map's radiance must
// therefore equal the albedo that it reports, for every material.
TEST(MapGuides, AlbedoIsTheLightOfABodyUnderAWhiteSky) {
    // The albedo of a rough coat is approximated by that of a smooth one, so this coat is nearly smooth.
    for (const char* material :
         {R"("matte" "rgb Kd" [0.7 0.3 0.1])", R"("mirror" "rgb Kr" [0.2 0.4 0.8])",
          R"("substrate" "rgb Kd" [0.5 0.2 0.6] "rgb Ks" [0.1 0.1 0.1] "float uroughness" 0 "float vroughness" 0)"}) {
        SCOPED_TRACE(material);
        const Pipeline pipeline(R"(
            LookAt 0 0 1  0 1 1  0 0 1
            Camera "perspective" "float fov" 60
            Film "image" "integer xresolution" 4 "integer yresolution" 4
            WorldBegin
            LightSource "infinite" "rgb L" [1 1 1]
            Translate 0 10 30
            Material )" + std::string(material) +
                                R"(
            Shape "sphere" "float radius" 20
            WorldEnd)");
        constexpr int kSize = 32;
        const Vec3 up(0, 0, 1);
        const CaptureSettings settings{MapLayout(Projection::EqualArea, kSize), 1024};
        const auto texels = size_t(settings.layout.texels());
        CapturedMap map;
        captureMap(pipeline.tracer, settings, {Vec3(0, 0, 0), up, 0, kError}, Frame::fromNormal(up), 5, map);
        ASSERT_EQ(map.albedo.size(), 3 * texels);
        const auto isSky = [&](int row, int column) { return map.distance[size_t(row * kSize + column)] < 0; };
        int body = 0, sky = 0;
        double difference = 0;
        // Texels that the body covers in part have a part of its radiance.
        for (int row = 1; row + 1 < kSize; ++row)
            for (int column = 1; column + 1 < kSize; ++column) {
                bool edge = false;
                for (int i = 0; i < 9; ++i) edge |= isSky(row + i / 3 - 1, column + i % 3 - 1) != isSky(row, column);
                if (edge) continue;
                ++(isSky(row, column) ? sky : body);
                for (size_t c = 0; c < 3; ++c) {
                    const size_t i = c * texels + size_t(row * kSize + column);
                    EXPECT_NEAR(map.radiance[i], map.albedo[i], 0.05f);
                    difference += double(map.radiance[i] - map.albedo[i]);
                    EXPECT_EQ(map.albedo[i] == 0, isSky(row, column));
                }
            }
        // At grazing angles the albedo varies within a texel. On average it does not matter which ray reports it.
        EXPECT_NEAR(difference / (3 * body), 0, 0.005);
        EXPECT_GT(body, 100);
        EXPECT_GT(sky, 100);
    }
}

// A spherical lamp of radius 5 inside a matte sphere of radius 10, with nothing between them.
Pipeline lampInASphere() {
    return Pipeline(R"(
        LookAt 0 0 1  0 1 1  0 0 1
        Camera "perspective" "float fov" 60
        Film "image" "integer xresolution" 4 "integer yresolution" 4
        WorldBegin
        AttributeBegin
            Material "none"
            AreaLightSource "diffuse" "rgb L" [1 1 1]
            Shape "sphere" "float radius" 5
        AttributeEnd
        Material "matte" "rgb Kd" [0.7 0.3 0.1]
        Shape "sphere" "float radius" 10
        WorldEnd)");
}

TEST(MapGuides, AlbedoIsThatBehindALampWithoutABody) {
    const Pipeline pipeline = lampInASphere();
    const Vec3 up(0, 0, 1);
    const CaptureSettings settings{MapLayout(Projection::EqualArea, 4), 1};
    CapturedMap map;
    captureMap(pipeline.tracer, settings, {Vec3(0, 0, 0), up, 0, kError}, Frame::fromNormal(up), 5, map);
    for (size_t i = 0; i < 16; ++i) {
        EXPECT_NEAR(map.distance[i], 5, 1e-3f);
        EXPECT_FLOAT_EQ(map.albedo[i], 0.7f);
        EXPECT_FLOAT_EQ(map.albedo[16 + i], 0.3f);
        EXPECT_FLOAT_EQ(map.albedo[32 + i], 0.1f);
    }
}

// The lamp's radiance is one, so the wall receives the irradiance pi (5 / 10)^2 from it, and with each reflection the
// albedo times as much again.
TEST(MapGuides, DirectLightIsWhatComesStraightFromTheLamp) {
    const Pipeline pipeline = lampInASphere();
    const Vec3 up(0, 0, 1);
    const CaptureSettings settings{MapLayout(Projection::EqualArea, 32), 1};
    double direct[3] = {}, all[3] = {};
    constexpr int kMaps = 40;
    CapturedMap map;
    for (int k = 0; k < kMaps; ++k) {
        captureMap(pipeline.tracer, settings, {Vec3(0, 0, 0), up, 0, kError}, Frame::fromNormal(up), uint64_t(k), map);
        for (size_t c = 0; c < 3; ++c)
            for (size_t i = 0; i < 1024; ++i) {
                direct[c] += map.direct[c * 1024 + i] / (1024. * kMaps);
                all[c] += map.radiance[c * 1024 + i] / (1024. * kMaps);
                ASSERT_LE(map.direct[c * 1024 + i], map.radiance[c * 1024 + i]);
            }
    }
    const double albedos[] = {0.7, 0.3, 0.1};
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(direct[c] / (albedos[c] / 4), 1, 0.02);
        EXPECT_NEAR(all[c] / (albedos[c] / 4 / (1 - albedos[c])), 1, 0.02);
    }
}

}  // namespace
}  // namespace drc::test
