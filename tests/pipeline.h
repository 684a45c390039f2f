// A scene text, ready to trace, and the estimators of its picture that must agree.
#pragma once
#include <memory>
#include <string>

#include "maps/indirect_pass.h"
#include "pbrt/scene_file.h"
#include "transport/camera_sample.h"
#include "z_test.h"

namespace drc::test {

struct Pipeline {
    explicit Pipeline(const std::string& text)
        : scene(pbrt::loadPbrtString(text)), accel(*scene), lights(*scene), tracer(*scene, accel, lights) {}

    int pixels() const { return int(scene->sensor.settings.region().count()); }
    // Camera ray `i` of a pixel. The sampler is left in the state in which the path continues.
    Ray cameraRay(int pixel, Sampler& sampler) const {
        const PixelRegion region = scene->sensor.settings.region();
        const Vec2 u = sampler.get2D();
        const Vec2 film(float(region.x0 + pixel % region.width()) + u.x,
                        float(region.y0 + pixel / region.width()) + u.y);
        return drc::cameraRay(scene->sensor, film, sampler).ray;
    }
    static Sampler sampler(uint64_t stream, int pixel, int i) {
        return Sampler(hashCombine(stream, uint64_t(pixel)), uint32_t(i));
    }

    Rgb path(int pixel, int i) const {
        Sampler s = sampler(1, pixel, i);
        const Ray ray = cameraRay(pixel, s);
        return tracer.radiance(ray, s);
    }
    Rgb direct(int pixel, int i) const {
        Sampler s = sampler(2, pixel, i);
        const Ray ray = cameraRay(pixel, s);
        return tracer.direct(ray, s);
    }
    Rgb tracedIndirect(int pixel, int i) const {
        Sampler s = sampler(3, pixel, i);
        const Ray ray = cameraRay(pixel, s);
        PrimaryHit hit;
        if (!tracer.primaryHit(ray, s, hit)) return Rgb(0.f);
        return hit.throughput * tracer.indirect(hit, s);
    }
    Rgb glossyIndirect(int pixel, int i) const {
        Sampler s = sampler(4, pixel, i);
        const Ray ray = cameraRay(pixel, s);
        return tracer.layers(ray, s, false).glossy;
    }
    // Indirect light of all lobes, as a sample of direct light includes it.
    Rgb indirectAlong(int pixel, int i) const {
        Sampler s = sampler(5, pixel, i);
        const Ray ray = cameraRay(pixel, s);
        const SampleLayers layers = tracer.layers(ray, s, true);
        return layers.glossy + layers.broad;
    }
    // Estimates every pixel with one of the functions above.
    Estimate estimate(Rgb (Pipeline::*way)(int pixel, int i) const, int samples, int group) const {
        return test::estimate(pixels(), samples, group, [&](int p, int i) { return (this->*way)(p, i); });
    }
    // The indirect layer of the broad lobes from radiance maps: mean and variance over independent passes with the same
    // spacing.
    Estimate cachedIndirect(const IndirectSettings& settings, float spacing, int passes) const {
        return estimateOf(cachedPasses(settings, spacing, passes));
    }
    // The pictures of single passes: [pass][pixel].
    std::vector<std::vector<Rgb>> cachedPasses(const IndirectSettings& settings, float spacing, int passes) const {
        const PixelRegion region = scene->sensor.settings.region();
        std::vector<std::vector<Rgb>> values(size_t(passes), std::vector<Rgb>(region.count()));
        for (int pass = 0; pass < passes; ++pass) {
            IndirectPass indirect(tracer, scene->sensor, settings, nullptr);
            indirect.run(pass, spacing, [&](int x, int y, int, const Rgb& value, float weight) {
                values[size_t(pass)][region.index(x, y)] = value * weight;
            });
        }
        return values;
    }

    std::unique_ptr<Scene> scene;
    Accel accel;
    LightSampler lights;
    PathTracer tracer;
};

// Sum of two independent estimates.
inline Estimate operator+(Estimate a, const Estimate& b) {
    for (size_t i = 0; i < a.mean.size(); ++i) {
        const auto [variance, freedom] = combine(a, b, i);
        a.mean[i] += b.mean[i];
        a.variance[i] = variance;
        a.freedom[i] = freedom;
    }
    return a;
}

}  // namespace drc::test
