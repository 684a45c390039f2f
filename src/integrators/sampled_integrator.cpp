#include "integrators/sampled_integrator.h"

#include "film/sample_pass.h"

namespace drc {
int halfOf(uint64_t seed, uint32_t index) {
    constexpr uint64_t kHalfStream = 0x2006;
    return int((index ^ (hashCombine(seed, hashCombine(kHalfStream, index / 2)) >> 32)) & 1);
}

std::vector<FilmLayerSpec> sampledLayers(const RenderParams& params, const Scene& scene, const RenderSettings& settings,
                                         bool direct) {
    const double quantum = radianceQuantum(settings.filmScale);
    std::vector<FilmLayerSpec> layers{{.name = kBeautyLayer, .groups = params.variance ? 2 : 1, .quantum = quantum}};
    const int halves = params.independentHalves ? 2 : 1;
    if (params.parts && direct) layers.push_back({.name = kDirectLayer, .groups = halves, .quantum = quantum});
    if (params.gBuffer) addGBufferSpec(layers, halves);
    if (params.surfaces) addMetSpec(layers, scene.bounds().radius());
    if (settings.transparentFilm) layers.push_back({.name = kAlphaLayer, .channels = 1});
    return layers;
}

SampledIntegrator::SampledIntegrator(const RenderContext& context)
    : context_(context),
      direct_(layerIndex(context, kDirectLayer)),
      gBuffer_(layerIndex(context, kGBufferLayer)),
      alpha_(layerIndex(context, kAlphaLayer)),
      met_(layerIndex(context, kMetLayer)) {}

void SampledIntegrator::sample(int x, int y, uint32_t index, CameraSample& sample, Film& film) {
    const CameraRay& camera = sample.camera;
    GBufferSample gBuffer;
    Rgb value(0.f), direct(0.f);
    if (camera.weight > 0) {
        const SampleParts parts{.gBuffer = gBuffer_ ? &gBuffer : nullptr, .direct = direct_ ? &direct : nullptr};
        value = radiance(camera.ray, sample.sampler, {x, y, index}, film, parts) * camera.weight;
    }
    const int group = groupOf(index), half = context_.params.independentHalves ? group : 0;
    film.layer(0).add(x, y, group, value, sample.filterWeight);
    if (direct_) film.layer(*direct_).add(x, y, half, direct * camera.weight, sample.filterWeight);
    if (gBuffer_) addGBufferSample(film.layer(*gBuffer_), x, y, gBuffer, sample.filterWeight, half);
    if (met_) addMet(film.layer(*met_), x, y, gBuffer);
    if (alpha_) {  // with a transparent film there is a G-buffer, too: see resolved()
        const float alpha[] = {gBuffer.covered ? 1.f : 0.f};
        film.layer(*alpha_).add(x, y, 0, alpha, sample.filterWeight);
    }
}

int SampledIntegrator::groupOf(uint32_t index) const {
    const RenderParams& params = context_.params;
    if (!params.variance) return 0;
    return params.independentHalves ? int(index & 1) : halfOf(params.seedOfFrame(), index);
}

LayeredPicture SampledIntegrator::picture(std::shared_ptr<const Film> film) const {
    LayeredPicture picture;
    picture.scale = context_.sensor.settings.filmScale;
    picture.film = std::move(film);
    const FilmLayer& samples = picture.film->layer(kBeauty);
    picture.layers.push_back(pictureLayer(*picture.film, kBeauty, "", picture.scale));
    fillUnsampled({&picture.layers[0].mean}, samples);
    if (direct_) {
        picture.direct = pictureLayer(*picture.film, kDirect, "direct", picture.scale).mean;
        fillUnsampled({&*picture.direct}, samples);
    }
    if (context_.params.variance) picture.samples = sampleCounts(samples);
    if (gBuffer_) picture.gBuffer = gBufferOf(*picture.film);
    if (met_)
        picture.surfaces = surfaceLayersOf(*picture.film, context_.scene, context_.accel, *context_.sensor.camera);
    if (met_ && context_.params.independentHalves) {
        picture.halves = halvesOf(samples, picture.scale);
        if (direct_) picture.directHalves = halvesOf(picture.film->layer(kDirect), picture.scale);
    }
    if (alpha_) {
        picture.alpha = alphaOf(picture.film->layer(kAlpha));
        fillUnsampled({&*picture.alpha}, samples);
    }
    picture.compose();
    return picture;
}

Preview SampledIntegrator::preview(const Film& film) const {
    const PixelRegion& region = film.region();
    const FilmLayer& samples = film.layer(kBeauty);
    const FilmLayer* alpha = alpha_ ? &film.layer(*alpha_) : nullptr;
    const float scale = context_.sensor.settings.filmScale;
    Preview preview{Image(region.width(), region.height()), {}, Image(region.width(), region.height(), {"X"})};
    if (alpha) preview.alpha.emplace(region.width(), region.height(), std::vector<std::string>{"A"});
    parallelFor(0, region.height(), 8, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            const int y = region.y0 + row;
            const auto lock = film.lockRow(y);
            for (int column = 0; column < region.width(); ++column) {
                const int x = region.x0 + column;
                preview.beauty.setRgb(column, row, clampNonNegative(samples.mean(x, y) * scale));
                preview.samples.at(column, row, 0) = float(samples.expected(x, y));
                if (alpha) preview.alpha->at(column, row, 0) = alphaAt(*alpha, x, y);
            }
        }
    });
    fillUnsampled({&preview.beauty}, preview.samples);
    if (alpha) fillUnsampled({&*preview.alpha}, preview.samples);
    return preview;
}

}  // namespace drc
