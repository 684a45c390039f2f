// A render as params -> state -> steps. Each step is one sweep over the film: a sample a pixel of direct light or of
// paths, or a pass of radiance maps. Between steps the picture can be looked at, and the render stopped.
#pragma once
#include <chrono>
#include <memory>

#include "cache/indirect_pass.h"
#include "render/film.h"
#include "render/film_variance.h"
#include "render/layer_filter.h"
#include "render/splat_film.h"

namespace drc {

enum class Integrator { Drc, Path, Direct, Bdpt };

struct RenderParams {
    Integrator integrator = Integrator::Drc;
    int spp = 32;     // samples a pixel: of paths, or of the direct layer
    int passes = 12;  // of radiance maps
    uint64_t seed = 0;
    PathSettings path;
    IndirectSettings indirect;
    float firstSpacing = kFirstSpacing;  // of the first pass, as a share of the frame's height
    // With a deadline spp and passes are ignored: steps are made until it. The first sweep, and the first pass, are
    // finished all the same: without them there is no picture, or one without indirect light.
    std::optional<std::chrono::steady_clock::time_point> deadline;
    // DRC: whether every second sweep of direct light follows its paths further and takes a sample of indirect light,
    // for the correction of the maps' errors.
    bool correct = true;
    // DRC: whether noise is filtered out of the layers, along surfaces.
    bool denoise = true;
    // How many of the sweeps also look at the surface that each pixel shows, for denoisers: RenderedImage::shown.
    int shownSweeps = 0;
    // Whether to keep count of each pixel's noise: RenderedImage::noise.
    bool noise = false;
    // Whether samples of an environment learn where its light comes in.
    bool guide = true;
    float directShare = 0.7f;  // of the time before a deadline that the direct layer gets
};

// Of the first surface that is no mirror or smooth glass; zero where there is none. Means over a pixel's samples.
struct ShownImages {
    Image albedo;  // share of light that it sends back, in [0, 1], times the mirrors' and glasses' before it
    Image normal;  // shading normal on the viewer's side, world space
    Image depth;   // one channel: length of the way there
};

// Of the camera's samples, as the film had them before any filter. Of DRC the maps' part is in it, as four groups of
// them tell; of BDPT without what light paths bring.
struct NoiseImages {
    Image variance;  // of each pixel's mean, R, G and B
    Image samples;   // one channel: their number
};

struct RenderedImage {
    Image beauty;                           // linear radiance times the film's scale, nowhere below zero
    std::optional<Image> direct, indirect;  // layers that sum to it (or to less than zero)
    std::optional<ShownImages> shown;       // if asked for
    std::optional<NoiseImages> noise;       // the same
};

class Renderer {
  public:
    // The scene must outlive the renderer; enhancer is needed for Integrator::Drc alone. stats may be null.
    Renderer(const Scene& scene, const RenderParams& params, std::shared_ptr<const Enhancer> enhancer, Stats* stats);
    ~Renderer();

    // One sweep. False: there was nothing left to do, or the deadline passed or `cancel` was raised; what a sweep had
    // done by then counts.
    bool step(const CancelToken* cancel = nullptr);
    // Share of the work (or of the time before the deadline) that is done, in [0, 1].
    double progress() const;
    // "direct 12 spp, indirect pass 5".
    std::string status() const;
    RenderedImage image() const;

    int samplesDone() const { return samplesDone_; }
    int passesDone() const { return passesDone_; }
    const PathTracer& tracer() const { return tracer_; }

  private:
    using Clock = std::chrono::steady_clock;
    void startGuide();
    // Whether there is one of all that makes up a picture.
    bool isWhole() const;
    bool sampleStep(const CancelToken* cancel);
    bool passStep(float spacing, const CancelToken* cancel);
    bool nextIsPass(float& spacing) const;
    // Of the next sweep of direct light: which group its samples belong to, and whether they are followed further.
    struct Turn {
        int group;
        bool follow;
    };
    Turn nextTurn() const;
    struct CameraSample;
    CameraSample cameraSample(int x, int y) const;
    // One sample of each pixel of a row.
    void sampleRow(int y, const Turn& turn);
    void showRow(int y);
    void bidirectionalRow(int y, SplatFilm::Catch& caught);
    NoiseImages noiseImages(float scale) const;
    uint32_t randomOf(uint64_t stream, int index) const;
    // Before a deadline: the spacing of the next pass, from what the last one cost.
    float spacingInTime() const;

    const Scene& scene_;
    RenderParams params_;
    Accel accel_;
    LightSampler lights_;
    PathTracer tracer_;
    std::optional<BidirectionalTracer> bdpt_;
    std::optional<SplatFilm> splats_;        // of bdpt_
    std::optional<EnvironmentGuide> guide_;  // none: there is no environment to learn about
    std::shared_ptr<const Enhancer> enhancer_;
    Stats* stats_;
    FilmLayer samples_;  // paths (those of bdpt_ but for splats), or the direct layer; of DRC's that which the camera
                         // sees of emitters
    FilmVariance variance_;
    FilmLayer shownAlbedo_, shownNormal_, shownDepth_;
    // DRC's alone. With the samples of direct light: what surfaces scatter of it; indirect light of lobes that maps
    // cannot hold; samples of what they can; and which surfaces they are. With the passes: what the maps give.
    SampleGroups lit_, narrow_, wide_, indirect_;
    ShownSurfaces surfaces_;
    int samplesDone_ = 0, passesDone_ = 0;
    Clock::time_point start_;
    double sampleSeconds_ = 0, passSeconds_ = 0;
    double lastSample_ = 0, lastPass_ = 0;
    float lastSpacing_ = 0;
};

}  // namespace drc
