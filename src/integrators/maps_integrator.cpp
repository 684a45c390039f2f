// Deep Radiance Caching as published: direct light is sampled at every pixel, indirect light comes from radiance maps,
// and paths trace the light of glossy lobes, which maps cannot resolve. SurfacePictureFilter filters the layers.
#include "film/sample_pass.h"
#include "integrators/integrator.h"
#include "reconstruct/layer_filter.h"

namespace drc {
namespace {

// Indices of the film's layers.
enum Layer { kEmission, kLit, kGlossy, kBroad, kMaps, kLobeGBuffer };

class MapsIntegrator final : public Integrator, public MapPasses {
  public:
    explicit MapsIntegrator(const RenderContext& context)
        : context_(context),
          settings_(context.params.indirect),
          gBuffer_(layerIndex(context, kGBufferLayer)),
          met_(layerIndex(context, kMetLayer)) {
        settings_.seed = hashCombine(context.params.seedOfFrame(), 0xd2c);
    }

    void sample(int x, int y, uint32_t index, CameraSample& sample, Film& film) override {
        const RenderParams& params = context_.params;
        const Turn turn = turnOf(index);
        // The group also depends on the pixel, so that each block of 2x2 pixels covers all four groups from its first
        // sample on.
        const int group = turn.group ^ (x & 1) ^ (2 * (y & 1));
        const CameraRay& camera = sample.camera;
        const bool seen = camera.weight > 0;
        GBufferSample gBuffer;
        SampleLayers layers;
        if (seen)
            layers = context_.tracer.layers(camera.ray, sample.sampler, turn.traceBroad, gBuffer_ ? &gBuffer : nullptr);
        layers.scale(camera.weight);
        const float weight = sample.filterWeight;
        film.layer(kEmission).add(x, y, params.variance ? group & 1 : 0, layers.emission, weight);
        film.layer(kLit).add(x, y, group, layers.lit, weight);
        film.layer(kGlossy).add(x, y, group, layers.glossy, weight);
        if (turn.traceBroad) film.layer(kBroad).add(x, y, group, layers.broad, weight);
        LobeGBuffer::add(film, kLobeGBuffer, x, y, layers, weight, seen);
        if (gBuffer_) addGBufferSample(film.layer(*gBuffer_), x, y, gBuffer, weight);
        if (met_) addMet(film.layer(*met_), x, y, gBuffer);
    }

    const MapPasses* mapPasses() const override { return this; }

    bool mapPass(int index, float spacing, int stride, Film& film, const CancelToken* cancel) const override {
        IndirectPass pass(context_.tracer, context_.sensor, settings_, context_.stats);
        const float height = float(context_.sensor.settings.film.height);
        // A pass is weighted by the square of its number of maps: noise falls with this number, and the interpolation
        // error with the spacing. Each pass has 1.58 times the weight of the one before, so the first passes fade out.
        const float importance = std::pow(context_.params.firstSpacing * height / spacing, 4.f);
        // As with the camera samples, no group may get every fourth point of a sequence.
        const int turn = int(random(kPassStream, index) % LayerFilter::kGroups);
        FilmLayer& maps = film.layer(kMaps);
        const bool whole = pass.run(
            index, spacing,
            [&](int x, int y, int sample, const Rgb& value, float filterWeight) {
                const auto lock = film.lockRow(y);
                maps.add(x, y, (sample ^ turn) % LayerFilter::kGroups, value, filterWeight, importance);
            },
            cancel, stride);
        if (context_.stats) context_.stats->add("maps", pass.mapCount());
        return whole;
    }

    LayeredPicture picture(std::shared_ptr<const Film> film) const override {
        LayeredPicture picture;
        picture.scale = context_.sensor.settings.filmScale;
        picture.film = std::move(film);
        for (const auto& [layer, part] : {std::pair("emission", "direct"), std::pair("lit", "direct"),
                                          std::pair("maps", "indirect"), std::pair("glossy", "indirect")}) {
            picture.layers.push_back(pictureLayer(*picture.film, layer, part, picture.scale));
            fillUnsampled({&picture.layers.back().mean}, picture.film->layer(layer));
        }
        if (context_.params.variance) picture.samples = sampleCounts(picture.film->layer(kEmission));
        if (gBuffer_) picture.gBuffer = gBufferOf(*picture.film);
        if (met_)
            picture.surfaces = surfaceLayersOf(*picture.film, context_.scene, context_.accel, *context_.sensor.camera);
        picture.compose();
        return picture;
    }

  private:
    static constexpr uint64_t kTurnStream = 0x2002, kPassStream = 0x2004;

    uint32_t random(uint64_t stream, int index) const {
        return uint32_t(hashCombine(context_.params.seedOfFrame(), hashCombine(stream, uint64_t(index))) >> 32);
    }

    // The group of the samples with an index, and whether they also trace broad indirect light.
    struct Turn {
        int group;
        bool traceBroad;
    };
    Turn turnOf(uint32_t index) const {
        // All samples continue one sequence. No group may get every fourth point of it, because these points are poorly
        // stratified; instead, each group gets a random one of every four consecutive samples.
        const uint32_t four = index / 4, eight = index / 8;
        const uint32_t group = (index ^ random(kTurnStream, int(2 * four))) % LayerFilter::kGroups;
        // Two of every four consecutive samples trace broad light, and in every eight, one of each group does.
        const bool follow = ((group ^ four ^ random(kTurnStream, int(2 * eight + 1))) & 1) == 0;
        return {int(group), context_.params.correct && follow};
    }

    const RenderContext context_;
    IndirectSettings settings_;
    const std::optional<size_t> gBuffer_, met_;  // indices of layers; none: the film has no such layer
};

}  // namespace

std::vector<FilmLayerSpec> mapsLayers(const RenderParams& params, const Scene& scene, const RenderSettings& settings) {
    constexpr auto kSingle = FilmLayerSpec::Storage::Single;
    constexpr int kGroups = LayerFilter::kGroups;
    std::vector<FilmLayerSpec> layers(kLobeGBuffer);
    layers[kEmission] = {
        .name = "emission", .groups = params.variance ? 2 : 1, .quantum = radianceQuantum(settings.filmScale)};
    layers[kLit] = {.name = "lit", .groups = kGroups, .storage = kSingle};
    layers[kGlossy] = {.name = "glossy", .groups = kGroups, .storage = kSingle};
    layers[kBroad] = {.name = "broad", .groups = kGroups, .storage = kSingle};
    layers[kMaps] = {.name = "maps", .groups = kGroups, .storage = kSingle};
    LobeGBuffer::addSpecs(layers, scene.bounds().radius());
    if (params.gBuffer) addGBufferSpec(layers);
    if (params.surfaces) addMetSpec(layers, scene.bounds().radius());
    return layers;
}

std::unique_ptr<Integrator> makeMapsIntegrator(const RenderContext& context) {
    return std::make_unique<MapsIntegrator>(context);
}

}  // namespace drc
