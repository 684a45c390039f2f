// Moving objects and cameras, through the whole pipeline.
#include <gtest/gtest.h>

#include "gathered_pictures.h"
#include "pipeline.h"

namespace drc {
namespace {

// How far above the point on the floor the rays of a map start.
constexpr float kError = 1e-5f;

using test::Estimate;
using test::expectSame;
using test::Pipeline;

std::string film(int width, int height) {
    return "Film \"image\" \"integer xresolution\" " + std::to_string(width) + " \"integer yresolution\" " +
           std::to_string(height) + "\n";
}

// A flying ball and a rotating ellipsoid on a floor beside a wall, with a lamp above. The camera may move as well.
std::string scene(bool cameraMoves, int width = 12, int height = 8) {
    return std::string("LookAt 0 -5 1.5  0 0 0.8  0 0 1\n") +
           (cameraMoves ? "ActiveTransform EndTime Translate 0.6 0 0 Rotate 8 0 1 0 ActiveTransform All\n" : "") +
           "Camera \"perspective\" \"float fov\" 45\n" + film(width, height) +
           "WorldBegin\nLightSource \"infinite\" \"rgb L\" [0.3 0.3 0.4]\n"
           "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [12 11 9]\nMaterial \"matte\" \"rgb Kd\" [0 0 0]\n"
           "Translate 0 0 3 ReverseOrientation Shape \"disk\" \"float radius\" 0.6\nAttributeEnd\n"
           "Material \"matte\" \"rgb Kd\" [0.7 0.7 0.6]\n"
           "Shape \"trianglemesh\" \"point P\" [-4 -4 0 4 -4 0 4 4 0 -4 4 0] \"integer indices\" [0 1 2 0 2 3]\n"
           "Shape \"trianglemesh\" \"point P\" [-4 1.5 0 4 1.5 0 4 1.5 4 -4 1.5 4] \"integer indices\" [0 1 2 0 2 3]\n"
           "AttributeBegin ActiveTransform EndTime Translate 1.2 0 0.8 ActiveTransform All\n"
           "Translate -1 0 0.5 Material \"matte\" \"rgb Kd\" [0.8 0.2 0.1] Shape \"sphere\" \"float radius\" 0.5\n"
           "AttributeEnd\nObjectBegin \"egg\" Material \"plastic\" \"float roughness\" 0.3\n"
           "Scale 0.9 0.3 0.3 Shape \"sphere\"\nObjectEnd\n"
           "Translate 1 0 1 ActiveTransform EndTime Rotate 100 0 1 0 ActiveTransform All ObjectInstance \"egg\"\n"
           "WorldEnd\n";
}

class Motion : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Camera, Motion, testing::Values(false, true),
                         [](const auto& i) { return i.param ? "Moves" : "StandsStill"; });

TEST_P(Motion, DirectAndIndirectAreThePath) {
    const Pipeline pipeline(scene(GetParam()));
    const auto of = [&](auto&& sample) { return test::estimate(pipeline.pixels(), 768, 32, sample); };
    const Estimate path = of([&](int p, int i) { return pipeline.path(p, i); });
    const Estimate direct = of([&](int p, int i) { return pipeline.direct(p, i); });
    expectSame(path, direct + of([&](int p, int i) { return pipeline.tracedIndirect(p, i); }), "direct + traced");

    IndirectSettings settings;
    settings.capture.layout = MapLayout(Projection::EqualArea, 16);  // fewer texels would be too coarse
    settings.primarySamples = 1;
    const Estimate narrow = of([&](int p, int i) { return pipeline.glossyIndirect(p, i); });
    const Estimate maps = pipeline.cachedIndirect(settings, 1, 40);
    expectSame(path, direct + narrow + maps, "direct + maps at every pixel");
}

// Radiance cells on moving surfaces are of all moments of the exposure together.
TEST_P(Motion, FinalGatherHasThePathTracersMeans) {
    const auto moving = pbrt::loadPbrtString(scene(GetParam(), 32, 16));
    const test::Gathered result = test::gather(*moving, {});
    const test::ZResult z = result.differencesBeyond(0.005);
    EXPECT_LT(z.worst, z.bound) << "a block is off by " << result.worstDifference();
    EXPECT_LT(result.meanError(), 0.02) << "too noisy to tell";
    EXPECT_GT(result.answered, 0.05) << "the cells are hardly asked";
}

// Under a uniform sky, objects that absorb nothing are as bright as the sky from everywhere. A shadow ray or bounce at
// another time than the camera ray's would hit the object in another place.
TEST(MovingFurnace, IsAsBrightAsTheSky) {
    const Pipeline pipeline(
        "LookAt 0 -5 0  0 0 0  0 0 1\nActiveTransform EndTime Translate 0.3 0 0 ActiveTransform All\n"
        "Camera \"perspective\" \"float fov\" 40\n" +
        film(8, 6) +
        "WorldBegin\nLightSource \"infinite\"\nMaterial \"matte\" \"rgb Kd\" [1 1 1]\n"
        "AttributeBegin ActiveTransform EndTime Translate 1 0 0.5 ActiveTransform All\n"
        "Translate -0.5 0 0 Shape \"sphere\"\nAttributeEnd\n"
        "ActiveTransform EndTime Rotate 140 0 1 0 ActiveTransform All Translate 1.3 0.2 0 Scale 0.2 0.5 0.4\n"
        "Shape \"sphere\"\nWorldEnd\n");
    const Estimate path = test::estimate(pipeline.pixels(), 256, 16, [&](int p, int i) { return pipeline.path(p, i); });
    double sum = 0;
    for (size_t i = 0; i < path.mean.size(); ++i) {
        EXPECT_NEAR(path.mean[i], 1, 0.02 + 5 * std::sqrt(path.variance[i]));
        sum += path.mean[i] / double(path.mean.size());
    }
    EXPECT_NEAR(sum, 1, 0.003);
}

// A map on a static wall must be the average over the exposure; a map on a moving surface is of the moment of its
// sample.
TEST(MovingMaps, AverageTheExposureWhereTheyStandStill) {
    // A black screen between the origin and the sky, which is gone for the second half of the exposure.
    const Pipeline pipeline(
        "TransformTimes 0.5 0.5\n" + film(4, 4) +
        "WorldBegin\nLightSource \"infinite\" \"rgb L\" [0 0 0]\nMaterial \"matte\" \"rgb Kd\" [0 0 0]\n"
        "ActiveTransform EndTime Translate 100 0 0 ActiveTransform All\n"
        "Shape \"trianglemesh\" \"point P\" [-50 -50 1 50 -50 1 50 50 1 -50 50 1] \"integer indices\" [0 1 2 0 2 3]\n"
        "WorldEnd\n");
    const CaptureSettings settings{MapLayout(Projection::EqualArea, 32), 1};
    const auto hitsNearThePole = [&](std::optional<float> time) {
        CapturedMap map;
        const Vec3 up(0, 0, 1);
        captureMap(pipeline.tracer, settings, {Vec3(0, 0, 0), up, 0, kError}, Frame::fromNormal(up), 7, map, time);
        int hits = 0, all = 0;
        for (int row = 8; row < 24; ++row)
            for (int column = 8; column < 24; ++column, ++all) hits += map.distance[size_t(row * 32 + column)] > 0;
        return double(hits) / all;
    };
    EXPECT_NEAR(hitsNearThePole(std::nullopt), 0.5, 0.05);
    EXPECT_EQ(hitsNearThePole(0.f), 1);
    EXPECT_EQ(hitsNearThePole(1.f), 0);

    SurfaceInteraction at;
    at.time = 0.3f;
    EXPECT_EQ(captureTime(at), std::nullopt);
    at.moves = true;
    EXPECT_EQ(captureTime(at), 0.3f);
}

}  // namespace
}  // namespace drc
