#include "render/session.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "base/log.h"
#include "film/sample_pass.h"
#include "render/deadline.h"
#include "transport/window_finder.h"

namespace drc {
namespace {

// The first words of a saved session's file.
constexpr const char* kFileKind = "drc render";
constexpr uint64_t kSampleStream = 0x2001, kProbeStream = 0x2003, kOddSampleStream = 0x2007;
// Number of the guide's voxels along the median distance from the camera to visible surfaces.
constexpr float kVoxelsInDistance = 8;
// First index, within a pixel, of samples of a focus; all other samples have lower indices.
constexpr uint32_t kFirstFocusSample = uint32_t(1) << 31;
// The square root of the number of camera rays that look for surfaces before rendering.
constexpr int kProbes = 16;
// The square root of the number of camera rays that look for windows.
constexpr int kViews = 48;

PathSettings pathSettings(const RenderParams& params) {
    PathSettings settings;
    settings.maxDepth = *params.maxDepth;
    settings.clamp = params.clamp;
    settings.broadAlpha = broadAlpha(params.indirect.capture.layout);
    return settings;
}

// The scene without media if it has some that the integrator does not render, else null.
std::unique_ptr<const Scene> reducedScene(const Scene& scene, const std::string& integrator) {
    if (traitsOf(integrator).media || scene.media.empty()) return nullptr;
    logWarning("--integrator " + integrator + " does not render participating media; they are left out");
    return withoutMedia(scene);
}

// Throws Error if the film would not fit into memory, before anything is built that takes time, or memory per pixel.
const Scene& ifThereIsMemory(const Scene& scene, const Sensor& sensor, const RenderParams& params) {
    Film::requireMemory(sensor.settings, filmLayers(params.integrator, params, scene, sensor.settings));
    return scene;
}

}  // namespace

Session::Session(const Scene& scene, Sensor sensor, const RenderParams& params, Stats* stats,
                 Schedule::Clock::time_point start, SessionRemains earlier)
    : sensor_(std::move(sensor)),
      params_(resolved(params, sensor_.settings)),
      ownScene_(reducedScene(scene, params_.integrator)),
      scene_(ifThereIsMemory(ownScene_ ? *ownScene_ : scene, sensor_, params_)),
      accel_(scene_, std::move(earlier.accel)),
      lights_(scene_, !sensor_.settings.transparentFilm),
      tracer_(scene_, accel_, lights_, pathSettings(params_)),
      stats_(stats),
      schedule_(params_, start, sensor_.settings.film.height, sensor_.settings.region().count()) {
    if (ownScene_) sensor_.medium = nullptr;
    const bool serves = earlier.cells && !params_.freezeCells && params_.cells &&
                        earlier.cells->origin == scene_.origin &&
                        earlier.cells->lightScale == sensor_.settings.filmScale &&
                        earlier.maxDepth == *params_.maxDepth && earlier.clamp == params_.clamp;
    if (serves) params_.carriedCells = std::move(earlier.cells);
    begin();
    warnIfBlack();
}

Session::~Session() = default;

std::vector<FilmLayerSpec> Session::layers() const {
    return filmLayers(params_.integrator, params_, scene_, sensor_.settings);
}

void Session::begin() {
    distance_ = medianDistance();
    integrator_ =
        makeIntegrator(params_.integrator, {scene_, sensor_, accel_, lights_, tracer_, params_, distance_, stats_});
    film_ = std::make_unique<Film>(sensor_.settings, layers());
    guide_.reset();
    tracer_.setGuide(nullptr);
    if (params_.guide && traitsOf(params_.integrator).guided) startGuide();
}

void Session::setSensor(std::shared_ptr<const Camera> camera, const FilmGeometry& film) {
    Sensor changed = sensor_;
    changed.camera = std::move(camera);
    changed.settings.film = film;
    if (!(film == sensor_.settings.film)) Film::requireMemory(changed.settings, layers());
    sensor_ = std::move(changed);
}

void Session::setCamera(std::shared_ptr<const Camera> camera, const FilmGeometry& film) {
    setSensor(std::move(camera), film);
    begin();
    restart();
}

void Session::moveCamera(std::shared_ptr<const Camera> camera, const FilmGeometry& film) {
    setSensor(std::move(camera), film);
    // With frozen cells a picture depends on no other camera, nor does the guide.
    if (params_.freezeCells || !integrator_->cameraMoved()) {
        begin();
    } else if (sensor_.settings.region() == film_->region()) {
        film_->clear();
    } else {
        film_ = std::make_unique<Film>(sensor_.settings, layers());
    }
    restart();
}

SessionRemains Session::takeRemains() {
    SessionRemains remains;
    remains.maxDepth = *params_.maxDepth;
    remains.clamp = params_.clamp;
    if (const RadianceCells* cells = integrator_->cells(); cells && !params_.freezeCells)
        remains.cells = std::make_shared<const CellCollection>(cells->carry(scene_.origin));
    remains.accel = std::make_unique<Accel>(std::move(accel_));
    return remains;
}

void Session::setFocus(const std::optional<PixelRegion>& focus) {
    const PixelRegion& all = film_->region();
    if (focus && (focus->x0 < all.x0 || focus->y0 < all.y0 || focus->x1 > all.x1 || focus->y1 > all.y1 ||
                  focus->x0 >= focus->x1 || focus->y0 >= focus->y1))
        throw std::out_of_range("the focus is not a part of the film");
    focus_ = focus;
    focusSamples_ = 0;
}

void Session::restart() {
    setFocus({});
    focusPasses_ = 0;
    waitingSamples_ = 0;
    const int height = sensor_.settings.film.height;
    schedule_ = Schedule(params_, Schedule::Clock::now(), height, sensor_.settings.region().count());
}

template <class F>
void Session::probe(int side, F&& f) const {
    const PixelRegion region = sensor_.settings.region();
    for (uint32_t i = 0; i < uint32_t(side * side); ++i) {
        Sampler sampler(hashCombine(params_.seedOfFrame(), kProbeStream), i);
        const Vec2 u = sampler.get2D();
        const Vec2 film(float(region.x0) + u.x * float(region.width()),
                        float(region.y0) + u.y * float(region.height()));
        const CameraRay camera = cameraRay(sensor_, film, sampler);
        if (camera.weight > 0) f(camera.ray, sampler);
    }
}

float Session::medianDistance() const {
    std::vector<float> distances;
    probe(kProbes, [&](const Ray& ray, Sampler& sampler) {
        PrimaryHit hit;
        if (tracer_.primaryHit(ray, sampler, hit)) distances.push_back(hit.distance);
    });
    if (distances.empty()) return 0;
    const auto median = distances.begin() + std::ptrdiff_t(distances.size() / 2);
    std::nth_element(distances.begin(), median, distances.end());
    return *median;
}

void Session::warnIfBlack() const {
    const auto emits = [](const auto& medium) { return !isBlack(medium->emission); };
    if (std::ranges::any_of(scene_.media, emits)) return;
    if (scene_.lights.empty()) {
        logWarning("the scene has no lights; the picture will be black");
        return;
    }
    const auto isSky = [](const Light* light) { return !light->isDelta(); };
    bool seesAnything =
        distance_ > 0 || std::ranges::any_of(lights_.infiniteLights(), isSky) || !lights_.backdrop().empty();
    // distance_ ignores surfaces that only emit or are black, so rays look for them here.
    if (!seesAnything)
        probe(kProbes, [&](const Ray& ray, Sampler&) {
            SurfaceInteraction hit;
            seesAnything = seesAnything || accel_.intersect(ray, hit);
        });
    if (!seesAnything)
        logWarning(
            fmt::format("the camera sees neither a surface nor a sky in {} directions; the picture will be black. "
                        "Does it look away from the scene?",
                        kProbes * kProbes));
}

void Session::startGuide() {
    const Light* brightest = nullptr;
    float most = 0;
    for (const Light* light : lights_.infiniteLights()) {
        const float power = luminance(light->power(1));
        if (light->isDelta() || !light->surrounds() || !(power > most)) continue;
        brightest = light;
        most = power;
    }
    if (brightest == nullptr) return;
    if (distance_ == 0) return;
    std::vector<Ray> views;
    if (brightest->bounds().empty())  // without a portal of its own
        probe(kViews, [&](const Ray& ray, Sampler&) { views.push_back(ray); });
    const EnvironmentWindows windows = windowsOnto(*brightest, accel_, views);
    logDebug(fmt::format("{} windows found", windows.count()));
    guide_.emplace(windows, distance_ / kVoxelsInDistance);
    tracer_.setGuide(&*guide_);
}

bool Session::step(const CancelToken* cancel, const CancelToken* abandon) {
    if (cancel && cancel->cancelled()) return false;
    if (focus_ && samplesDone() > 0) return focusPass(cancel, abandon);
    const std::optional<Schedule::Work> work = schedule_.next(film_->passes(), film_->mapPasses());
    if (!work) return false;
    std::optional<DeadlineToken> inTime;
    if (const auto deadline = schedule_.deadline(); deadline && hasPicture())
        cancel = &inTime.emplace(*deadline, cancel).token();
    const auto start = Schedule::Clock::now();
    bool whole = false;
    if (work->kind == Schedule::Work::Kind::Maps) {
        whole = integrator_->mapPasses()->mapPass(work->index, work->spacing, work->stride, *film_, cancel);
        film_->setMapPasses(film_->mapPasses() + whole);
    } else {
        whole = samplePass(work->index, cancel, abandon);
    }
    const auto took = Schedule::Clock::now() - start;
    schedule_.finished(*work, took, whole);
    if (stats_) stats_->timer(work->kind == Schedule::Work::Kind::Maps ? "map passes" : "sample passes").add(took);
    const auto learning = Schedule::Clock::now();
    if (whole && work->kind == Schedule::Work::Kind::Samples) integrator_->samplePassDone(samplesDone());
    if (guide_ && whole && (work->kind == Schedule::Work::Kind::Maps || SamplePass{work->index}.endsSample()))
        guide_->update();
    if (stats_) stats_->timer("learning between passes").add(Schedule::Clock::now() - learning);
    return whole;
}

bool Session::samplePass(int index, const CancelToken* cancel, const CancelToken* abandon) {
    const auto isAbandoned = [&] { return abandon != nullptr && abandon->cancelled(); };
    const SamplePass pass{index};
    const uint32_t number = uint32_t(params_.firstSample) + pass.sample();
    const PixelRegion& region = film_->region();
    parallelFor(
        region.y0, region.y1, 1,
        [&](int y, int) {
            const auto lock = film_->lockRow(y);
            // A pass that was cancelled continues with the rows that it did not reach.
            if (film_->rowPasses(y) > index || isAbandoned()) return;
            pass.forEachColumn(y - region.y0, region.width(), [&](int column) {
                if (isAbandoned()) return;
                const int x = region.x0 + column;
                takeSamples(x, y, integrator_->samplesOf(x, y, number));
            });
            if (!isAbandoned()) film_->setRowPasses(y, index + 1);
        },
        cancel);
    return film_->passes() > index;
}

void Session::takeSamples(int x, int y, const PixelSamples& samples) {
    const uint64_t stream = pixelStream(params_.seedOfFrame(), kSampleStream, x, y);
    const uint64_t odd = params_.independentHalves ? pixelStream(params_.seedOfFrame(), kOddSampleStream, x, y) : 0;
    for (uint32_t i = samples.first; i < samples.first + uint32_t(samples.count); ++i) {
        CameraSample sample = !params_.independentHalves ? cameraSample(sensor_, x, y, stream, i)
                                                         : cameraSample(sensor_, x, y, i & 1 ? odd : stream, i / 2);
        integrator_->sample(x, y, i, sample, *film_);
    }
}

bool Session::focusPass(const CancelToken* cancel, const CancelToken* abandon) {
    // A cancelled pass is not continued: the next pass takes other samples.
    const uint32_t index = kFirstFocusSample + focusPasses_++;
    parallelFor(
        focus_->y0, focus_->y1, 1,
        [&](int y, int) {
            const auto lock = film_->lockRow(y);
            for (int x = focus_->x0; x < focus_->x1; ++x) {
                if (abandon != nullptr && abandon->cancelled()) return;
                takeSamples(x, y, {index, 1});
            }
        },
        cancel);
    const auto isRaised = [](const CancelToken* token) { return token != nullptr && token->cancelled(); };
    if (isRaised(cancel) || isRaised(abandon)) return false;
    ++focusSamples_;
    // Learns after as many samples as a pass over the whole film takes.
    waitingSamples_ += focus_->count();
    if (waitingSamples_ >= film_->region().count()) {
        waitingSamples_ = 0;
        integrator_->focusPassesDone();
        if (guide_) guide_->update();
    }
    return true;
}

std::string Session::fileHeader(const std::string& identity) const {
    return fmt::format("{} 4 {} {} {}", kFileKind, params_.integrator, film_->description(""), identity);
}

void Session::save(const std::string& path, const std::string& identity) const {
    if (focusPasses_ > 0) throw std::logic_error("a session that has had a focus cannot be saved");
    StateWriter file(path, fileHeader(identity));
    integrator_->saveState(file);
    file.value(uint8_t(guide_.has_value()));
    if (guide_) guide_->save(file);
    film_->save(file);
    file.commit();
}

void Session::load(const std::string& path, const std::string& identity) {
    StateReader file(path, kFileKind, fileHeader(identity));
    const std::function<void()> place = integrator_->loadState(file);
    if (bool(file.value<uint8_t>()) != guide_.has_value()) file.fail("it does not say the same of the environment");
    const std::function<void()> placeGuide = guide_ ? guide_->load(file) : [] {};
    // Throws before it changes anything, so it comes before the functions that install states.
    film_->load(file);
    place();
    placeGuide();
}

LayeredPicture Session::picture() const {
    return integrator_->picture(std::shared_ptr<const Film>(std::shared_ptr<const Film>(), film_.get()));
}

void Session::endSampling() { integrator_->endSampling(); }

int Session::samplesDone() const { return SamplePass::wholeSamples(film_->passes()); }

std::string Session::status() const {
    const std::string samples = samplesDone() > 0 || film_->passes() == 0
                                    ? fmt::format("{} spp", samplesDone())
                                    : fmt::format("1 of {} pixels sampled", film_->passes() == 1 ? 16 : 4);
    if (integrator_->mapPasses() == nullptr) return samples;
    return fmt::format("direct {}, indirect pass {}", samples, film_->mapPasses());
}

}  // namespace drc
