#include "maps/indirect_pass.h"

#include <atomic>
#include <chrono>

namespace drc {
namespace {

// Purposes of random numbers, mixed into the seed so that each purpose has its own stream.
constexpr uint64_t kPrimary = 0x1001, kGather = 0x1002, kCapture = 0x1003, kOffset = 0x1004, kFill = 0x1005,
                   kFallback = 0x1006;
constexpr int kRowsPerTask = 1;
// The number of maps that each level may add, as a share of the number of grid maps in the bands so far. This keeps the
// cost of a pass proportional to its number of grid maps, even in a scene full of edges. Pixels that still lack maps
// are left to the path-traced fallback and to later, denser passes.
constexpr float kFillBudget = 0.5f;
constexpr float kSmallestFill = 2.5f;  // smallest radius of added maps, pixels
// If the weights of a pixel's maps sum to less than this share of minCoverage, its light is path-traced instead.
constexpr float kLeastShare = 0.25f;

PixelSite pixelSite(const PrimaryHit& hit, const LobeMask& broad, const Vec2& film) {
    PixelSite site;
    site.p = hit.surface.p;
    site.n = faceForward(hit.surface.ng, hit.surface.wo);
    site.film = film;
    site.pixelSize = hit.surface.footprint;
    site.transmits = hit.bsdf.has(LobeFlags::Transmission, broad);
    return site;
}

}  // namespace

IndirectPass::IndirectPass(const PathTracer& tracer, const Sensor& sensor, const IndirectSettings& settings,
                           Stats* stats)
    : tracer_(tracer), sensor_(sensor), settings_(settings), stats_(stats) {
    settings_.capture.shutter = sensor.camera->shutter();
    if (!settings_.denoiser) settings_.denoiser = makeIdentityMapDenoiser();
}

uint64_t IndirectPass::stream(int x, int y, uint64_t purpose) const {
    return pixelStream(settings_.seed, purpose, x, y);
}

bool IndirectPass::broadHit(int x, int y, int index, Vec2& film, float& weight, PrimaryHit& hit) const {
    CameraSample sample = cameraSample(sensor_, x, y, stream(x, y, kPrimary), uint32_t(index));
    film = sample.film;
    weight = sample.filterWeight;
    if (!(sample.camera.weight > 0) || !tracer_.primaryHit(sample.camera.ray, sample.sampler, hit)) return false;
    hit.throughput *= sample.camera.weight;
    return hit.bsdf.hasWithin(tracer_.broad());
}

void IndirectPass::captureSites(std::span<MapSite> sites, size_t first, size_t level, const State& state) {
    const auto group = hashCombine(uint64_t(state.pass), uint64_t(level));
    struct Request {
        MapSite* site;
        bool back;
        SpawnPoint from;
        std::optional<float> time;
        uint64_t stream;
    };
    std::vector<std::array<Request, 2>> found(sites.size());
    std::vector<uint8_t> counts(sites.size());
    parallelFor(0, int(sites.size()), 8, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            MapSite& site = sites[size_t(i)];
            const uint64_t stream =
                hashCombine(hashCombine(settings_.seed, kCapture), hashCombine(group, uint64_t(first) + uint64_t(i)));
            Sampler sampler(hashCombine(stream, 1), 0);
            PrimaryHit hit;
            const CameraRay camera = cameraRay(sensor_, site.film, sampler);
            if (!(camera.weight > 0) || !tracer_.primaryHit(camera.ray, sampler, hit) ||
                !hit.bsdf.hasWithin(tracer_.broad()))
                continue;
            site.p = hit.surface.p;
            site.n = faceForward(hit.surface.ng, hit.surface.wo);
            const std::optional<float> time = captureTime(hit.surface);
            uint8_t& n = counts[size_t(i)];
            const SpawnPoint from = hit.surface.spawnPoint();
            found[size_t(i)][n++] = {&site, false, from, time, hashCombine(stream, 2)};
            if (hit.bsdf.has(LobeFlags::Transmission, tracer_.broad()))
                found[size_t(i)][n++] = {&site, true, from, time, hashCombine(stream, 3)};
        }
    });
    std::vector<Request> requests;
    for (size_t i = 0; i < sites.size(); ++i)
        for (size_t k = 0; k < counts[i]; ++k) requests.push_back(found[i][k]);

    const MapLayout& layout = settings_.capture.layout;
    const Vec3 up = sensor_.camera->up();
    const int batch = settings_.denoiser->batchSize();
    parallelFor(
        0, int(requests.size()), batch,
        [&](int begin, int end) {
            if (state.cancelled()) return;
            std::vector<CapturedMap> maps(size_t(end - begin));
            using Clock = std::chrono::steady_clock;
            const auto start = Clock::now();
            for (int i = begin; i < end; ++i) {
                const Request& r = requests[size_t(i)];
                const Frame frame = mapFrame(r.back ? -r.site->n : r.site->n, up);
                captureMap(tracer_, settings_.capture, r.from, frame, r.stream, maps[size_t(i - begin)], r.time);
            }
            const auto captured = Clock::now();
            settings_.denoiser->denoise(maps, layout);
            const auto denoised = Clock::now();
            for (int i = begin; i < end; ++i) {
                const Request& r = requests[size_t(i)];
                (r.back ? r.site->back : r.site->front) = RadianceMap(maps[size_t(i - begin)], layout);
                (r.back ? r.site->hasBack : r.site->hasFront) = true;
            }
            if (stats_) {
                stats_->add("maps captured", end - begin);
                stats_->timer("map capture").add(captured - start);
                stats_->timer("map denoising").add(denoised - captured);
            }
        },
        state.cancel);
    mapCount_ += int(requests.size());
}

bool IndirectPass::run(int pass, float spacing, const Add& add, const CancelToken* cancel, int stride) {
    mapCount_ = 0;
    if (spacing <= 1) return runPerPixel(pass, add, cancel);
    Sampler offsets(hashCombine(settings_.seed, kOffset), uint32_t(pass));
    const RenderSettings& film = sensor_.settings;
    const PixelRegion region = film.region();
    const Vec2 margin = film.filter->radius();
    PassMaps maps(MapGrid(region, spacing, offsets.get2D()), region, std::max(margin.x, margin.y),
                  settings_.interpolation);
    // A pipeline over bands: while the grid of band b is captured, maps are added to band b - 1; then the pixels of
    // band b - 2, whose maps are complete, gather.
    State state{pass, stride, cancel, std::vector<size_t>(size_t(settings_.fillLevels) + 1)};
    const auto exists = [&](int band) { return band >= 0 && band < maps.bandCount(); };
    for (int band = 0; band < maps.bandCount() + 2 && !state.cancelled(); ++band) {
        parallelFor(0, 2, 1, [&](int part, int) {
            if (part == 0) {
                if (exists(band)) captureGrid(maps, band, state);
                return;
            }
            if (exists(band - 1)) fillIn(maps, band - 1, spacing, state);
            if (exists(band - 2)) gatherPixels(maps, band - 2, state, add);
        });
        if (exists(band - 3)) maps.release(band - 3);
    }
    return !state.cancelled();
}

void IndirectPass::captureGrid(PassMaps& maps, int band, const State& state) {
    const std::span<MapSite> sites = maps.addGrid(band);
    captureSites(sites, size_t(maps.pointsThrough(band)) - sites.size(), 0, state);
}

void IndirectPass::fillIn(PassMaps& maps, int band, float spacing, State& state) {
    // How well the maps cover a pixel.
    struct Pixel {
        PixelSite site;
        float coverage = -1;  // sum of weights; -1: no primary hit
    };
    const PixelRegion region = maps.pixels(band), film = sensor_.settings.region();
    std::vector<Pixel> pixels(region.count());
    parallelFor(region.y0, region.y1, kRowsPerTask, [&](int begin, int end) {
        for (int y = begin; y < end && !state.cancelled(); ++y)
            for (int x = region.x0; x < region.x1; ++x) {
                if (state.skips(film, x, y)) continue;
                Pixel& pixel = pixels[region.index(x, y)];
                Vec2 position;
                float weight;
                PrimaryHit hit;
                if (!broadHit(x, y, state.pass * settings_.primarySamples, position, weight, hit)) continue;
                pixel.site = pixelSite(hit, tracer_.broad(), position);
                pixel.coverage = maps.coverage(band, pixel.site, 0);
            }
    });

    const size_t budget = size_t(kFillBudget * float(maps.pointsThrough(band))) + 1;
    for (size_t level = 1; level <= size_t(settings_.fillLevels) && !state.cancelled(); ++level) {
        const float radius = spacing / float(1 << level);
        if (radius < kSmallestFill) break;
        // With a stride, pixels off the lattice are represented by the lattice pixel above and to the left of them.
        const auto onLattice = [&](int x, int y) {
            x -= (x - film.x0) % state.stride;
            y -= (y - film.y0) % state.stride;
            return y < region.y0 ? nullptr : &pixels[region.index(x, y)];
        };
        const auto lacking = [&](int x, int y) {
            const Pixel* pixel = onLattice(x, y);
            return pixel && pixel->coverage >= 0 && pixel->coverage < settings_.minCoverage;
        };
        const auto order = [&](int x, int y) {
            return hashCombine(stream(x, y, kFill), uint64_t(state.pass) << 8 | uint64_t(level));
        };
        const auto position = [&](int x, int y) { return onLattice(x, y)->site.film; };
        size_t& filled = state.filled[level];
        const std::vector<Vec2> points = fillPoints(region, radius, budget - filled, lacking, order, position);
        captureSites(maps.addLevel(band, radius, points), filled, level, state);
        filled += points.size();
        if (state.cancelled()) return;
        parallelFor(0, int(pixels.size()), 4096, [&](int begin, int end) {
            for (auto i = size_t(begin); i < size_t(end); ++i)
                if (pixels[i].coverage >= 0) pixels[i].coverage += maps.coverage(band, pixels[i].site, level);
        });
    }
}

void IndirectPass::gatherPixels(const PassMaps& maps, int band, const State& state, const Add& add) const {
    const PixelRegion region = maps.pixels(band), film = sensor_.settings.region();
    std::atomic<int64_t> fallbacks{0};
    const auto start = std::chrono::steady_clock::now();
    parallelFor(region.y0, region.y1, kRowsPerTask, [&](int begin, int end) {
        std::vector<WeightedSite> around;
        for (int y = begin; y < end && !state.cancelled(); ++y)
            for (int x = region.x0; x < region.x1; ++x)
                for (int sample = 0; sample < settings_.primarySamples && !state.skips(film, x, y); ++sample) {
                    const int index = state.pass * settings_.primarySamples + sample;
                    Vec2 position;
                    float weight;
                    PrimaryHit hit;
                    if (!broadHit(x, y, index, position, weight, hit)) {
                        add(x, y, sample, Rgb(0.f), weight);
                        continue;
                    }
                    maps.findAround(band, pixelSite(hit, tracer_.broad(), position),
                                    kLeastShare * settings_.minCoverage, around);
                    if (around.empty()) fallbacks.fetch_add(1, std::memory_order_relaxed);
                    const Rgb value = shade(hit, around, x, y, index);
                    add(x, y, sample, value * hit.throughput, weight);
                }
    });
    if (stats_) {
        stats_->add("pixels without a map", fallbacks.load());
        stats_->timer("gather").add(std::chrono::steady_clock::now() - start);
    }
}

Rgb IndirectPass::shade(const PrimaryHit& hit, std::span<const WeightedSite> sites, int x, int y, int index) const {
    if (!sites.empty()) {
        const auto n = uint32_t(settings_.gatherSamples);
        return gather(hit, tracer_.broad(), sites, settings_.gatherSamples, stream(x, y, kGather), uint32_t(index) * n);
    }
    Sampler sampler(stream(x, y, kFallback), uint32_t(index));
    return tracer_.indirect(hit, sampler, tracer_.broad());
}

bool IndirectPass::runPerPixel(int pass, const Add& add, const CancelToken* cancel) {
    const PixelRegion region = sensor_.settings.region();
    const MapLayout& layout = settings_.capture.layout;
    const Vec3 up = sensor_.camera->up();
    std::atomic<int> maps{0};
    parallelFor(
        region.y0, region.y1, kRowsPerTask,
        [&](int begin, int end) {
            std::vector<CapturedMap> captured(1);
            for (int y = begin; y < end; ++y)
                for (int x = region.x0; x < region.x1; ++x)
                    for (int sample = 0; sample < settings_.primarySamples; ++sample) {
                        const int index = pass * settings_.primarySamples + sample;
                        if (cancel && cancel->cancelled()) return;
                        Vec2 position;
                        float weight;
                        PrimaryHit hit;
                        if (!broadHit(x, y, index, position, weight, hit)) {
                            add(x, y, sample, Rgb(0.f), weight);
                            continue;
                        }
                        MapSite site;
                        site.p = hit.surface.p;
                        site.n = faceForward(hit.surface.ng, hit.surface.wo);
                        const uint64_t capturing = hashCombine(stream(x, y, kCapture), uint64_t(index));
                        const auto capture = [&](const Vec3& n, uint64_t side) {
                            // Captured at the time of the sample, because no other pixel uses this map.
                            captureMap(tracer_, settings_.capture, hit.surface.spawnPoint(), mapFrame(n, up),
                                       hashCombine(capturing, side), captured[0], hit.surface.time);
                            settings_.denoiser->denoise(captured, layout);
                            maps.fetch_add(1, std::memory_order_relaxed);
                            return RadianceMap(captured[0], layout);
                        };
                        site.front = capture(site.n, 0);
                        if (hit.bsdf.has(LobeFlags::Transmission, tracer_.broad())) site.back = capture(-site.n, 1);
                        const WeightedSite one{&site, 1};
                        const Rgb value = shade(hit, {&one, 1}, x, y, index);
                        add(x, y, sample, value * hit.throughput, weight);
                    }
        },
        cancel);
    mapCount_ = maps.load();
    return !(cancel && cancel->cancelled());
}

}  // namespace drc
