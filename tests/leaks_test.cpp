// Light leaks: a ray that misses a surface it should hit must not see the sky.
#include <gtest/gtest.h>

#include "math/warp.h"
#include "pipeline.h"

namespace drc {
namespace {

using test::Pipeline;

const std::string kSky = "WorldBegin\nLightSource \"infinite\"\n";

// Number of paths that see light when started on the inside of a unit ball, transformed by `still` or instanced.
int litPaths(const Pipeline& pipeline, const Transform& still) {
    int lit = 0;
    for (int i = 0; i < 500; ++i) {
        Sampler sampler(11, uint32_t(i));
        Ray ray;
        ray.time = sampler.get1D();
        const auto& instances = pipeline.scene->instances;
        const Transform toWorld = instances.empty() ? still : instances[0].objectToWorld.at(ray.time);
        ray.d = sampleUniformSphere(sampler.get2D());
        ray.o = toWorld.point(sampleUniformSphere(sampler.get2D()) * 0.99f);
        lit += !isBlack(pipeline.tracer.radiance(ray, sampler));
    }
    return lit;
}

// If a ray missed the inside of a closed ball at any bounce, it would see the sky.
TEST(Leaks, NoSkyIsSeenWithinAClosedBall) {
    // Something at zero, so that the scene is not moved there when it is loaded.
    const std::string white = "Material \"matte\" \"rgb Kd\" [1 1 1]\nShape \"sphere\" \"float radius\" 0.01\n";
    const std::string object = "ObjectBegin \"ball\"\nShape \"sphere\"\nObjectEnd\n";
    const std::string far = "Translate 300 180 -90\n", turned = "Rotate 33 1 2 3 Scale 2 1.5 2.5\n";
    const std::string moving = "ActiveTransform EndTime Translate 0.4 0.3 0 Rotate 20 0 1 0.01 ActiveTransform All\n";
    const Transform place = Transform::translate(Vec3(300, 180, -90)) * Transform::rotate(33, Vec3(1, 2, 3)) *
                            Transform::scale(2, 1.5f, 2.5f);
    for (const std::string& world : {far + turned + "Shape \"sphere\"\n",                  //
                                     object + far + turned + "ObjectInstance \"ball\"\n",  //
                                     moving + far + turned + "Shape \"sphere\"\n",         //
                                     object + moving + far + turned + "ObjectInstance \"ball\"\n"})
        EXPECT_EQ(litPaths(Pipeline(kSky + white + world + "WorldEnd\n"), place), 0) << world;
}

// A white ball inside more surfaces without material than a path passes through, all inside a black one.
TEST(Leaks, NoSkyIsSeenThroughManySurfacesWithoutMaterial) {
    std::string world = "Material \"none\"\n";
    for (int i = 0; i < 300; ++i) world += "Shape \"sphere\" \"float radius\" " + std::to_string(2 + 0.01 * i) + "\n";
    world += "Material \"matte\" \"rgb Kd\" [0 0 0]\nShape \"sphere\" \"float radius\" 8\n";
    const std::string ball = "Material \"matte\" \"rgb Kd\" [1 1 1]\nShape \"sphere\" \"float radius\" 0.5\n";
    const Pipeline pipeline(kSky + world + ball + "WorldEnd\n");
    Ray ray;
    ray.o = Vec3(0, 0, 1);
    for (const float z : {1.f, -1.f}) {  // towards the black surface and towards the ball
        ray.d = normalize(Vec3(0.1f, 0.2f, z));
        for (uint32_t i = 0; i < 4; ++i) {
            Sampler sampler(1, i);
            EXPECT_EQ(pipeline.tracer.radiance(ray, sampler), Rgb(0.f));
            EXPECT_EQ(pipeline.tracer.direct(ray, sampler), Rgb(0.f));
        }
    }
}

}  // namespace
}  // namespace drc
