// Compares a map's estimate of its own noise with the variance over many maps.
#include <gtest/gtest.h>

#include "maps/map_capture.h"
#include "pipeline.h"
#include "test_scenes.h"

namespace drc::test {
namespace {

// How far above the point on the floor the rays of a map start.
constexpr float kError = 1e-5f;

TEST(MapDeviation, IsNoLessThanTheSpreadOfMapsAndNotMuchMore) {
    const Pipeline pipeline(R"(
        LookAt 0 0 1  0 1 1  0 0 1
        Camera "perspective" "float fov" 60
        Film "image" "integer xresolution" 4 "integer yresolution" 4
        WorldBegin
        LightSource "infinite" "rgb L" [1 0.5 0.2]
        Material "matte" "rgb Kd" [0.7 0.6 0.5]
        Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-5 -5 0  5 -5 0  5 5 0  -5 5 0]
        Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-2 1 0  2 1 0  2 1 2  -2 1 2]
        Shape "sphere" "float radius" 0.7
        WorldEnd)");
    constexpr int kMaps = 200, kSamples = 8;
    const Vec3 up(0, 0, 1), origin(-1.5f, 0.3f, 0);
    CaptureSettings settings{MapLayout(Projection::EqualArea, 8), kSamples};
    const size_t values = size_t(3 * settings.layout.texels());
    std::vector<double> sum(values), squares(values), estimated(values);
    for (int k = 0; k < kMaps; ++k) {
        CapturedMap map, plain;
        settings.deviations = false;
        captureMap(pipeline.tracer, settings, {origin, up, 0, kError}, Frame::fromNormal(up), uint64_t(k), plain);
        settings.deviations = true;
        captureMap(pipeline.tracer, settings, {origin, up, 0, kError}, Frame::fromNormal(up), uint64_t(k), map);
        EXPECT_TRUE(plain.deviation.empty());
        ASSERT_EQ(plain.radiance, map.radiance);
        ASSERT_EQ(map.deviation.size(), values);
        for (size_t i = 0; i < values; ++i) {
            sum[i] += map.radiance[i];
            squares[i] += double(map.radiance[i]) * map.radiance[i];
            estimated[i] += double(map.deviation[i]) * map.deviation[i] / kMaps;
        }
    }
    // Variances, averaged over the texels.
    double spread = 0, estimate = 0;
    for (size_t i = 0; i < values; ++i) {
        spread += (squares[i] - sum[i] * sum[i] / kMaps) / (kMaps - 1);
        estimate += estimated[i];
    }
    EXPECT_GT(spread, 0);
    EXPECT_GT(estimate / spread, 0.95);
    EXPECT_LT(estimate / spread, 3);
    RecordProperty("ratio", std::to_string(estimate / spread));
    CapturedMap single;
    settings.samplesPerTexel = 1;
    captureMap(pipeline.tracer, settings, {origin, up, 0, kError}, Frame::fromNormal(up), 1, single);
    EXPECT_TRUE(single.deviation.empty());
}

}  // namespace
}  // namespace drc::test
