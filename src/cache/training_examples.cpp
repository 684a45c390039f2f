#include "cache/training_examples.h"

#include "neural/safetensors.h"

namespace drc {
namespace {

constexpr uint64_t kViewpoint = 0x3001, kInput = 0x3002, kTarget = 0x3003;

struct Example {
    std::vector<CapturedMap> inputs;
    CapturedMap target;
    bool valid = false;
};

Example makeExample(const PathTracer& tracer, const ExampleSettings& settings, int index) {
    const Scene& scene = tracer.scene();
    const PixelRegion region = scene.settings.region();
    // One sequence over the film: any number of viewpoints is spread evenly.
    Sampler sampler(hashCombine(settings.seed, kViewpoint), uint32_t(index));
    const Vec2 u = sampler.get2D();
    const Vec2 film(float(region.x0) + u.x * float(region.width()), float(region.y0) + u.y * float(region.height()));
    const Vec2 uLens = sampler.get2D();
    const CameraRay camera = scene.camera->generateRay(film, uLens, sampler.get1D());
    Example example;
    PrimaryHit hit;
    if (!(camera.weight > 0) || !tracer.primaryHit(camera.ray, sampler, hit)) return example;
    Vec3 n = faceForward(hit.surface.ng, hit.surface.wo);
    // What is seen through the surface is as good an example as what is seen in front of it.
    if (hit.bsdf.hasWideTransmission() && sampler.get1D() < 0.5f) n = -n;
    const Frame frame = mapFrame(n, scene.camera->up());
    const auto capture = [&](int samples, uint64_t stream, CapturedMap& map) {
        const CaptureSettings once{settings.layout, samples};
        captureMap(tracer, once, hit.surface.p, hit.surface.ng, frame, hit.surface.footprint,
                   hashCombine(hashCombine(settings.seed, stream), uint64_t(index)), map, captureTime(hit.surface));
    };
    capture(settings.targetSamples, kTarget, example.target);
    float sum = 0;
    for (const float r : example.target.radiance) sum += r;
    if (!(sum > 0)) return example;
    example.inputs.resize(size_t(settings.inputs));
    for (int i = 0; i < settings.inputs; ++i) capture(1, kInput + (uint64_t(i) << 32), example.inputs[size_t(i)]);
    example.valid = true;
    return example;
}

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

ExampleSet makeExamples(const PathTracer& tracer, const ExampleSettings& settings, Progress* progress,
                        const CancelToken* cancel) {
    std::vector<Example> examples(size_t(settings.viewpoints));
    parallelFor(
        0, settings.viewpoints, 1,
        [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                examples[size_t(i)] = makeExample(tracer, settings, i);
                if (progress) progress->add();
            }
        },
        cancel);
    ExampleSet set;
    for (const Example& example : examples) {
        if (!example.valid) continue;
        ++set.count;
        for (const CapturedMap& input : example.inputs) {
            append(set.radiance, input.radiance);
            append(set.normal, input.normal);
            append(set.distance, input.distance);
        }
        append(set.target, example.target.radiance);
    }
    return set;
}

void writeExamples(const std::string& path, const ExampleSet& examples, const ExampleSettings& settings,
                   const std::string& scene) {
    const int64_t n = examples.count, r = settings.inputs, s = settings.layout.size();
    const std::vector<TensorToWrite> tensors{{"radiance", {n, r, 3, s, s}, examples.radiance.data()},
                                             {"normal", {n, r, 3, s, s}, examples.normal.data()},
                                             {"distance", {n, r, 1, s, s}, examples.distance.data()},
                                             {"target", {n, 3, s, s}, examples.target.data()}};
    writeSafetensors(path, tensors,
                     {{"format", "drc-examples-1"},
                      {"projection", projectionName(settings.layout.projection())},
                      {"scene", scene},
                      {"spp", std::to_string(settings.targetSamples)},
                      {"seed", std::to_string(settings.seed)}});
}

}  // namespace drc
