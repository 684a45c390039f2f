#include "maps/training_examples.h"

#include <fmt/core.h>

#include <atomic>
#include <map>
#include <mutex>
#include <set>

#include "neural/safetensors.h"
#include "transport/camera_sample.h"

namespace drc {
namespace {

constexpr uint64_t kViewpoint = 0x3001, kInput = 0x3002, kTarget = 0x3003;
// Increase this number whenever the same settings produce different examples than before.
constexpr int kDrawing = 1;

Sampler viewpointSampler(const ExampleSettings& settings, int viewpoint) {
    const uint64_t stream = hashCombine(settings.seed, kViewpoint);
    // Each cell has its own jitter. Without cells, a single sequence spreads any number of viewpoints evenly over the
    // film.
    if (settings.tiles > 0) return {hashCombine(stream, uint64_t(viewpoint)), 0};
    return {stream, uint32_t(viewpoint)};
}

Vec2 onFilm(const ExampleSettings& settings, const PixelRegion& film, int viewpoint, Vec2 u) {
    if (settings.tiles > 0) {
        const Vec2 cell(float(viewpoint % settings.tiles), float(viewpoint / settings.tiles));
        u = (cell + u) / float(settings.tiles);
    }
    return {float(film.x0) + u.x * float(film.width()), float(film.y0) + u.y * float(film.height())};
}

}  // namespace

ShardHeader shardHeader(const ExampleSettings& settings, const std::string& scene, uint64_t sceneHash) {
    const PathSettings path;
    const std::string others =
        fmt::format("{} {:016x} {} {} {}", kDrawing, sceneHash, path.maxDepth, path.rouletteDepth, path.clamp);
    return {.scene = scene,
            .layout = settings.layout,
            .inputs = settings.inputs,
            .targetSamples = settings.targetSamples,
            .seed = settings.seed,
            .viewpoints = settings.viewpoints(),
            .tiles = settings.tiles,
            .settings = hashBytes(others.data(), others.size())};
}

Vec2 viewpointOnFilm(const ExampleSettings& settings, const PixelRegion& film, int viewpoint) {
    return onFilm(settings, film, viewpoint, viewpointSampler(settings, viewpoint).get2D());
}

std::optional<TrainingExample> makeExample(const PathTracer& tracer, const ExampleSettings& settings, int viewpoint) {
    const Scene& scene = tracer.scene();
    Sampler sampler = viewpointSampler(settings, viewpoint);
    TrainingExample example;
    example.viewpoint = viewpoint;
    example.film = onFilm(settings, scene.sensor.settings.region(), viewpoint, sampler.get2D());
    const CameraRay camera = cameraRay(scene.sensor, example.film, sampler);
    PrimaryHit hit;
    if (!(camera.weight > 0) || !tracer.primaryHit(camera.ray, sampler, hit)) return std::nullopt;
    example.bounces = hit.bounces;
    example.time = captureTime(hit.surface);
    Vec3 n = faceForward(hit.surface.ng, hit.surface.wo);
    // A map behind a translucent surface is as good an example as a map in front of it.
    if (hit.bsdf.has(LobeFlags::Transmission, tracer.broad()) && sampler.get1D() < 0.5f) n = -n;
    const Frame frame = mapFrame(n, scene.sensor.camera->up());
    const auto capture = [&](int samples, uint64_t stream, CapturedMap& map) {
        const CaptureSettings how{settings.layout, samples, samples > 1, scene.sensor.camera->shutter()};
        captureMap(tracer, how, hit.surface.spawnPoint(), frame,
                   hashCombine(hashCombine(settings.seed, stream), uint64_t(viewpoint)), map, example.time);
    };
    CapturedMap target;
    capture(settings.targetSamples, kTarget, target);
    example.target = std::move(target.radiance);
    example.targetDeviation = std::move(target.deviation);
    // An example without a usable target, such as a black one, is discarded, so its inputs are not needed.
    if (!isSound(example)) return std::nullopt;
    example.inputs.resize(size_t(settings.inputs));
    for (int i = 0; i < settings.inputs; ++i) capture(1, kInput + (uint64_t(i) << 32), example.inputs[size_t(i)]);
    if (!isSound(example)) return std::nullopt;
    return example;
}

void writeExamples(const PathTracer& tracer, const ExampleSettings& settings, ExampleShardWriter& shard,
                   const std::function<void(bool)>& done, const CancelToken* cancel) {
    const int end = settings.viewpoints();
    std::atomic<int> next{shard.next()};
    std::mutex mutex;
    std::map<int, std::string> waiting;  // finished examples that wait for an earlier viewpoint, by viewpoint
    const auto work = [&] {
        while (!(cancel && cancel->cancelled())) {
            const int viewpoint = next.fetch_add(1);
            if (viewpoint >= end) return;
            const auto example = makeExample(tracer, settings, viewpoint);
            std::string record = example ? encodeExample(*example, settings.layout) : "";
            const std::lock_guard lock(mutex);
            waiting.emplace(viewpoint, std::move(record));
            for (auto first = waiting.begin(); first != waiting.end() && first->first == shard.next();
                 first = waiting.erase(first)) {
                shard.append(first->second);
                done(!first->second.empty());
            }
        }
    };
    // Each thread runs one piece of the loop and draws the next viewpoint whenever it finishes one, so that no example
    // waits long for an earlier one.
    parallelFor(0, threadCount(), 1, [&](int, int) {
        try {
            work();
        } catch (...) {
            next = end;
            throw;
        }
    });
}

int writeExamples(const PathTracer& tracer, const ExampleSettings& settings, const IisptWriter& folder,
                  const std::function<void(bool)>& done, const CancelToken* cancel) {
    const PixelRegion film = tracer.scene().sensor.settings.region();
    std::set<std::pair<int, int>> taken;
    std::vector<char> first(size_t(settings.viewpoints()));
    for (int i = 0; i < settings.viewpoints(); ++i) {
        const Vec2 at = viewpointOnFilm(settings, film, i);
        first[size_t(i)] = taken.emplace(int(at.x), int(at.y)).second;
    }
    std::mutex mutex;
    std::atomic<int> there{0};
    const auto write = [&](int viewpoint) {
        if (!first[size_t(viewpoint)]) return false;
        const auto example = makeExample(tracer, settings, viewpoint);
        if (example) folder.write(*example);
        return example.has_value();
    };
    parallelFor(
        0, settings.viewpoints(), 1,
        [&](int viewpoint, int) {
            if (first[size_t(viewpoint)] && folder.has(viewpointOnFilm(settings, film, viewpoint))) {
                ++there;
                return;
            }
            const bool gave = write(viewpoint);
            const std::lock_guard lock(mutex);
            done(gave);
        },
        cancel);
    return there;
}

}  // namespace drc
