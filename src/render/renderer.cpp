#include "render/renderer.h"

#include <fmt/core.h>

#include "base/error.h"
#include "base/memory.h"
#include "render/deadline.h"

namespace drc {
namespace {

constexpr uint64_t kSampleStream = 0x2001, kShownStream = 0x2005, kTurnStream = 0x2002, kPassStream = 0x2004,
                   kProbeStream = 0x2003;
// Of the guide: voxels between the camera and what it sees.
constexpr float kVoxelsInDistance = 8;
// Pixels. Below it more passes serve better than more maps in one.
constexpr float kFinestInTime = 3;

double seconds(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

// Throws Error if the layers of the picture do not fit into memory: before anything is made.
const Scene& withinMemory(const Scene& scene, const RenderParams& params) {
    // The layers, what is known of the surfaces, and what filters and files are made from; and what is shown of them.
    const double bytesPerPixel = 984 + (params.shownSweeps > 0 ? 150 : 0) + (params.noise ? 64 : 0);
    const RenderSettings& settings = scene.settings;
    try {
        const MemoryClaim memory(
            double(settings.region().count()) * bytesPerPixel,
            fmt::format("a picture of {} x {} pixels", settings.region().width(), settings.region().height()));
    } catch (const Error& error) {
        throw Error(settings.filmAt,
                    std::string(error.what()) + "; choose a smaller --resolution, or a part of it by --crop");
    }
    return scene;
}

}  // namespace

Renderer::Renderer(const Scene& scene, const RenderParams& params, std::shared_ptr<const Enhancer> enhancer,
                   Stats* stats)
    : scene_(withinMemory(scene, params)),
      params_(params),
      accel_(scene),
      lights_(scene),
      tracer_(scene, accel_, lights_, params.path),
      enhancer_(std::move(enhancer)),
      stats_(stats),
      samples_(scene.settings.region()),
      start_(Clock::now()) {
    if (params.integrator == Integrator::Drc) {
        const PixelRegion& region = samples_.region();
        for (SampleGroups* groups : {&lit_, &narrow_, &wide_, &indirect_}) *groups = SampleGroups(region);
        surfaces_ = ShownSurfaces(region);
    }
    if (params.integrator == Integrator::Bdpt) {
        const PixelRegion& region = samples_.region();
        bdpt_.emplace(scene, accel_, lights_, params.path, double(region.count()));
        splats_.emplace(region, *scene.settings.filter);
    }
    if (params.shownSweeps > 0)
        for (FilmLayer* layer : {&shownAlbedo_, &shownNormal_, &shownDepth_}) *layer = FilmLayer(samples_.region());
    if (params.noise) variance_ = FilmVariance(samples_.region());
    params_.indirect.seed = hashCombine(params.seed, 0xd2c);
    if (params_.guide && !bdpt_) startGuide();
}

Renderer::~Renderer() = default;

void Renderer::startGuide() {
    const Light* brightest = nullptr;
    float most = 0;
    for (const Light* light : lights_.infiniteLights()) {
        const float power = luminance(light->power(1));
        if (light->isDelta() || !(power > most)) continue;
        brightest = light;
        most = power;
    }
    if (brightest == nullptr) return;
    // Voxels in proportion to the distances that the picture shows.
    constexpr int kProbes = 16;
    std::vector<float> distances;
    const PixelRegion& region = samples_.region();
    for (uint32_t i = 0; i < kProbes * kProbes; ++i) {
        Sampler sampler(hashCombine(params_.seed, kProbeStream), i);
        const Vec2 u = sampler.get2D(), uLens = sampler.get2D();
        const Vec2 film(float(region.x0) + u.x * float(region.width()),
                        float(region.y0) + u.y * float(region.height()));
        PrimaryHit hit;
        const CameraRay camera = scene_.camera->generateRay(film, uLens, sampler.get1D());
        if (camera.weight > 0 && tracer_.primaryHit(camera.ray, sampler, hit)) distances.push_back(hit.distance);
    }
    if (distances.empty()) return;
    const auto median = distances.begin() + std::ptrdiff_t(distances.size() / 2);
    std::nth_element(distances.begin(), median, distances.end());
    guide_.emplace(*brightest, *median / kVoxelsInDistance);
    tracer_.setGuide(&*guide_);
}

bool Renderer::nextIsPass(float& spacing) const {
    if (params_.integrator != Integrator::Drc) return false;
    spacing = passSpacing(passesDone_, scene_.settings.film.height, params_.firstSpacing);
    if (!params_.deadline) {
        // In turns, so that an interrupted render has both in proportion.
        if (passesDone_ >= params_.passes) return false;
        return samplesDone_ >= params_.spp ||
               double(passesDone_) / params_.passes <= double(samplesDone_) / params_.spp;
    }
    if (passesDone_ == 0 || samplesDone_ == 0) return samplesDone_ > 0;
    const double total = sampleSeconds_ + passSeconds_;
    spacing = spacingInTime();
    return spacing > 0 && sampleSeconds_ > params_.directShare * total;
}

float Renderer::spacingInTime() const {
    const double left = seconds(*params_.deadline - Clock::now());
    // The first pass is cheap and makes the picture whole. The next goes as fine as lets four passes, each with the
    // usual 1.26 times the maps of the one before, fill what is left of their share.
    constexpr double kPassesInTime = 4;
    const double growth = 1 / sqr(kSpacingFactor);
    double cost = lastPass_ * growth;
    if (passesDone_ == 1) {
        const double sum = (std::pow(growth, kPassesInTime) - 1) / (growth - 1);
        cost = std::max(cost, (1 - params_.directShare) * left / sum);
    }
    // It must end in time: with fewer maps if need be, not at all if it would be much coarser.
    if (cost > 0.9 * left) {
        if (0.5 * lastPass_ > left) return 0;
        cost = 0.9 * left;
    }
    return std::max(kFinestInTime, float(lastSpacing_ * std::sqrt(lastPass_ / cost)));
}

bool Renderer::isWhole() const {
    return samplesDone_ > 0 && (params_.integrator != Integrator::Drc || passesDone_ > 0);
}

bool Renderer::step(const CancelToken* cancel) {
    if (cancel && cancel->cancelled()) return false;
    std::optional<DeadlineToken> inTime;
    if (params_.deadline) {
        if (isWhole()) {
            if (Clock::now() >= *params_.deadline) return false;
            cancel = &inTime.emplace(*params_.deadline, cancel).token();
        }
    } else if (samplesDone_ >= params_.spp &&
               (params_.integrator != Integrator::Drc || passesDone_ >= params_.passes)) {
        return false;
    }
    float spacing = 0;
    const bool whole = nextIsPass(spacing) ? passStep(spacing, cancel) : sampleStep(cancel);
    if (guide_) guide_->update();
    return whole;
}

uint32_t Renderer::randomOf(uint64_t stream, int index) const {
    return uint32_t(hashCombine(params_.seed, hashCombine(stream, uint64_t(index))) >> 32);
}

Renderer::Turn Renderer::nextTurn() const {
    // All sweeps go on with one sequence. The members of a group must not be every fourth point of it, which are not
    // well distributed at all: of each four that follow on each other, a group has one at random.
    const auto random = [&](uint32_t turn) { return randomOf(kTurnStream, int(turn)); };
    const auto done = uint32_t(samplesDone_), four = done / 4, eight = done / 8;
    const uint32_t group = (done ^ random(2 * four)) % SampleGroups::kGroups;
    // Two of each four are followed, and of each eight one of each group.
    const bool follow = ((group ^ four ^ random(2 * eight + 1)) & 1) == 0;
    return {int(group), params_.integrator == Integrator::Drc && params_.correct && follow};
}

bool Renderer::sampleStep(const CancelToken* cancel) {
    const auto start = Clock::now();
    const PixelRegion& region = samples_.region();
    if (bdpt_) {
        // In bands, because what their light paths bring to the film is kept until each is done.
        constexpr int kBand = 64;
        for (int y = region.y0; y < region.y1; y += kBand) {
            const int end = std::min(y + kBand, region.y1);
            std::vector<SplatFilm::Catch> catches(size_t(end - y));
            parallelFor(
                y, end, 1, [&](int row, int) { bidirectionalRow(row, catches[size_t(row - y)]); }, cancel);
            splats_->add(catches);
        }
    } else {
        const Turn turn = nextTurn();
        const auto rows = [&](int begin, int end) {
            for (int y = begin; y < end; ++y) sampleRow(y, turn);
        };
        parallelFor(region.y0, region.y1, 1, rows, cancel);
    }
    if (samplesDone_ < params_.shownSweeps) {
        const auto rows = [&](int begin, int end) {
            for (int y = begin; y < end; ++y) showRow(y);
        };
        parallelFor(region.y0, region.y1, 1, rows, cancel);
    }
    ++samplesDone_;
    lastSample_ = seconds(Clock::now() - start);
    sampleSeconds_ += lastSample_;
    const bool paths = params_.integrator == Integrator::Path || bdpt_;
    if (stats_) stats_->timer(paths ? "path samples" : "direct samples").add(Clock::now() - start);
    return !(cancel && cancel->cancelled());
}

// What each sample of a pixel begins with.
struct Renderer::CameraSample {
    Sampler sampler;
    float filterWeight;
    CameraRay camera;
};

Renderer::CameraSample Renderer::cameraSample(int x, int y) const {
    const uint64_t pixel = (uint64_t(uint32_t(y)) << 32) | uint32_t(x);
    Sampler sampler(hashCombine(params_.seed, hashCombine(kSampleStream, pixel)), uint32_t(samplesDone_));
    const FilterSample f = scene_.settings.filter->sample(sampler.get2D());
    const Vec2 film(float(x) + 0.5f + f.offset.x, float(y) + 0.5f + f.offset.y);
    const Vec2 uLens = sampler.get2D();
    const CameraRay camera = scene_.camera->generateRay(film, uLens, sampler.get1D());
    return {sampler, f.weight, camera};
}

void Renderer::sampleRow(int y, const Turn& turn) {
    const bool path = params_.integrator == Integrator::Path, drc = params_.integrator == Integrator::Drc;
    for (int x = samples_.region().x0; x < samples_.region().x1; ++x) {
        auto [sampler, filterWeight, camera] = cameraSample(x, y);
        const bool seen = camera.weight > 0;
        if (path) {
            const Rgb radiance = seen ? tracer_.radiance(camera.ray, sampler) : Rgb(0.f);
            samples_.add(x, y, radiance * camera.weight, filterWeight);
            if (params_.noise) variance_.add(x, y, radiance * (camera.weight * filterWeight));
            continue;
        }
        SampleLayers layers;
        layers.traceWide = turn.follow;
        const Rgb direct = seen ? tracer_.direct(camera.ray, sampler, drc ? &layers : nullptr) : Rgb(0.f);
        samples_.add(x, y, (direct - layers.lit) * camera.weight, filterWeight);
        if (params_.noise) variance_.add(x, y, (direct + layers.narrow) * (camera.weight * filterWeight));
        if (!drc) continue;
        layers.scale(camera.weight);
        // Each two by two pixels have all groups, also before each pixel has.
        const int group = turn.group ^ (x & 1) ^ (2 * (y & 1));
        lit_.add(x, y, group, layers.lit, filterWeight);
        narrow_.add(x, y, group, layers.narrow, filterWeight);
        if (turn.follow) wide_.add(x, y, group, layers.wide, filterWeight);
        surfaces_.add(x, y, layers, filterWeight, seen);
    }
}

void Renderer::showRow(int y) {
    for (int x = samples_.region().x0; x < samples_.region().x1; ++x) {
        // Along the same ray as the picture's sample, but with other numbers after it, so that the picture is what it
        // is without.
        const auto [used, filterWeight, camera] = cameraSample(x, y);
        const uint64_t pixel = (uint64_t(uint32_t(y)) << 32) | uint32_t(x);
        Sampler sampler(hashCombine(params_.seed, hashCombine(kShownStream, pixel)), uint32_t(samplesDone_));
        PrimaryHit hit;
        Rgb albedo(0.f);
        Vec3 normal(0.f);
        float depth = 0;
        if (camera.weight > 0 && tracer_.primaryHit(camera.ray, sampler, hit)) {
            albedo = hit.throughput * hit.bsdf.albedo(hit.surface.wo, LobeFlags::NonSpecular);
            for (int c = 0; c < 3; ++c) albedo[c] = albedo[c] > 0 ? std::min(albedo[c], 1.f) : 0.f;
            normal = faceForward(hit.bsdf.frame().n, hit.surface.wo);
            depth = hit.distance;
        }
        shownAlbedo_.add(x, y, albedo, filterWeight);
        shownNormal_.add(x, y, Rgb(normal.x, normal.y, normal.z), filterWeight);
        shownDepth_.add(x, y, Rgb(depth), filterWeight);
    }
}

void Renderer::bidirectionalRow(int y, SplatFilm::Catch& caught) {
    for (int x = samples_.region().x0; x < samples_.region().x1; ++x) {
        auto [sampler, filterWeight, camera] = cameraSample(x, y);
        const Rgb radiance = camera.weight > 0 ? bdpt_->radiance(camera.ray, sampler, caught.splats) : Rgb(0.f);
        samples_.add(x, y, radiance * camera.weight, filterWeight);
        if (params_.noise) variance_.add(x, y, radiance * (camera.weight * filterWeight));
        ++caught.paths;
    }
}

bool Renderer::passStep(float spacing, const CancelToken* cancel) {
    const auto start = Clock::now();
    IndirectPass pass(tracer_, *enhancer_, params_.indirect, stats_);
    // By the square of its maps: noise falls with their number, and what interpolation smears with their spacing. Each
    // pass has 1.58 times the say of the one before, and the first ones fade.
    const auto importance = float(std::pow(double(params_.firstSpacing) * scene_.settings.film.height / spacing, 4));
    // As with the sweeps, no group may have every fourth point of a sequence.
    const int turn = int(randomOf(kPassStream, passesDone_) % SampleGroups::kGroups);
    const bool whole = pass.run(
        passesDone_, spacing,
        [&](int x, int y, int sample, const Rgb& value, float filterWeight) {
            indirect_.add(x, y, (sample ^ turn) % SampleGroups::kGroups, value, filterWeight, importance);
        },
        cancel);
    ++passesDone_;
    lastPass_ = seconds(Clock::now() - start);
    lastSpacing_ = spacing;
    passSeconds_ += lastPass_;
    if (stats_) {
        stats_->timer("indirect passes").add(Clock::now() - start);
        stats_->add("maps", pass.mapCount());
    }
    return whole;
}

double Renderer::progress() const {
    if (params_.deadline) {
        const double total = seconds(*params_.deadline - start_);
        return total > 0 ? std::clamp(seconds(Clock::now() - start_) / total, 0.0, 1.0) : 1;
    }
    const double samples = std::min(1.0, double(samplesDone_) / std::max(1, params_.spp));
    if (params_.integrator != Integrator::Drc) return samples;
    // Passes cost more and more: by the maps they have.
    const auto maps = [](int n) { return std::pow(double(kSpacingFactor), -2.0 * n) - 1; };
    const double passes = params_.passes > 0 ? maps(passesDone_) / maps(params_.passes) : 1;
    return params_.directShare * samples + (1 - params_.directShare) * std::min(1.0, passes);
}

std::string Renderer::status() const {
    if (params_.integrator != Integrator::Drc) return fmt::format("{} spp", samplesDone_);
    return fmt::format("direct {} spp, indirect pass {}", samplesDone_, passesDone_);
}

NoiseImages Renderer::noiseImages(float scale) const {
    const PixelRegion& region = samples_.region();
    NoiseImages noise{Image(region.width(), region.height()), Image(region.width(), region.height(), {"X"})};
    for (int y = 0; y < region.height(); ++y)
        for (int x = 0; x < region.width(); ++x) {
            const int px = region.x0 + x, py = region.y0 + y;
            Rgb variance = variance_.ofMean(px, py);
            if (params_.integrator == Integrator::Drc) variance += indirect_.varianceOfMean(px, py);
            noise.variance.setRgb(x, y, variance * (scale * scale));
            noise.samples.at(x, y, 0) = float(variance_.count(px, py));
        }
    return noise;
}

RenderedImage Renderer::image() const {
    const float scale = scene_.settings.filmScale;
    RenderedImage result;
    if (params_.shownSweeps > 0) {
        const int width = samples_.region().width(), height = samples_.region().height();
        result.shown =
            ShownImages{shownAlbedo_.image(1), Image(width, height, {"X", "Y", "Z"}), Image(width, height, {"Z"})};
        result.shown->normal.data() = shownNormal_.image(1).data();
        const Image depth = shownDepth_.image(1);
        for (size_t i = 0; i < depth.pixelCount(); ++i) result.shown->depth.data()[i] = depth.data()[3 * i];
    }
    if (params_.noise) result.noise = noiseImages(scale);
    result.beauty = samples_.image(scale);
    // Filters with negative lobes undershoot beside what is bright. As in pbrt a picture has no light below zero; its
    // layers may.
    const auto withoutNegative = [&]() -> RenderedImage& {
        for (float& v : result.beauty.data())
            if (v < 0) v = 0;
        return result;
    };
    if (splats_) {
        const PixelRegion& region = samples_.region();
        for (int y = 0; y < region.height(); ++y)
            for (int x = 0; x < region.width(); ++x)
                result.beauty.setRgb(x, y,
                                     result.beauty.rgb(x, y) + splats_->value(region.x0 + x, region.y0 + y) * scale);
    }
    if (params_.integrator != Integrator::Drc) return withoutNegative();
    const auto sampled = [&](const SampleGroups& samples, const LayerFilter& filter) {
        return params_.denoise ? filter.smooth(samples) : samples.image();
    };
    const auto add = [scale](const Image& from, Image& to) {
        for (size_t i = 0; i < to.data().size(); ++i) to.data()[i] += from.data()[i] * scale;
    };
    add(sampled(lit_, LayerFilter(surfaces_, Scattering::All)), result.beauty);
    result.direct = result.beauty;
    const LayerFilter wide(surfaces_, Scattering::Wide);
    result.indirect = sampled(indirect_, wide);
    if (params_.correct && passesDone_ > 0) wide.correct(*result.indirect, wide_);
    for (float& v : result.indirect->data()) v *= scale;
    add(sampled(narrow_, LayerFilter(surfaces_, Scattering::Narrow)), *result.indirect);
    for (size_t i = 0; i < result.beauty.data().size(); ++i) result.beauty.data()[i] += result.indirect->data()[i];
    return withoutNegative();
}

}  // namespace drc
