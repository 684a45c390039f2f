#include "film/layered_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "film/sample_pass.h"

namespace drc {
namespace {

constexpr int kGBufferChannels = 8;

// Calls f(row) for all rows, in parallel.
template <class F>
void forEachRow(int height, const F& f) {
    parallelFor(0, height, 8, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) f(row);
    });
}

}  // namespace

PictureLayer& LayeredPicture::layer(const std::string& name) {
    const auto found =
        std::find_if(layers.begin(), layers.end(), [&](const PictureLayer& l) { return l.name == name; });
    assert(found != layers.end());
    return *found;
}

Image LayeredPicture::part(const std::string& name) const {
    if (direct && name == "direct") return *direct;
    Image sum(film->region().width(), film->region().height());
    for (const PictureLayer& layer : layers)
        if (direct || name.empty() || layer.part == name)
            for (size_t i = 0; i < sum.data().size(); ++i) sum.data()[i] += layer.mean.data()[i];
    if (direct && name == "indirect")
        for (size_t i = 0; i < sum.data().size(); ++i) sum.data()[i] -= direct->data()[i];
    return sum;
}

Image LayeredPicture::variance() const {
    Image sum(film->region().width(), film->region().height());
    for (const PictureLayer& layer : layers)
        if (layer.variance)
            for (size_t i = 0; i < sum.data().size(); ++i) sum.data()[i] += layer.variance->data()[i];
    return sum;
}

Rgb LayeredPicture::partAt(const std::string& name, int x, int y) const {
    if (direct && name == "direct") return direct->rgb(x, y);
    Rgb sum(0.f);
    for (const PictureLayer& layer : layers)
        if (direct || name.empty() || layer.part == name) sum += layer.mean.rgb(x, y);
    return direct && name == "indirect" ? sum - direct->rgb(x, y) : sum;
}

Rgb LayeredPicture::varianceAt(int x, int y) const {
    Rgb sum(0.f);
    for (const PictureLayer& layer : layers)
        if (layer.variance) sum += layer.variance->rgb(x, y);
    return sum;
}

void LayeredPicture::compose() {
    beauty = part("");
    // Pixel filters with negative lobes undershoot beside bright areas. As in pbrt, only the final picture is clamped
    // at zero; its layers are not.
    for (float& v : beauty.data()) v = std::max(v, 0.f);
}

void balanceBeauty(Image& beauty, const RgbMatrix& matrix) {
    forEachRow(beauty.height(), [&](int y) {
        for (int x = 0; x < beauty.width(); ++x) beauty.setRgb(x, y, clampNonNegative(matrix * beauty.rgb(x, y)));
    });
}

void LayeredPicture::balance(const RgbMatrix& matrix) {
    const auto forEachPixel = [](Image& image, const auto& f) {
        forEachRow(image.height(), [&](int y) {
            for (int x = 0; x < image.width(); ++x) image.setRgb(x, y, f(image.rgb(x, y)));
        });
    };
    for (PictureLayer& layer : layers) {
        forEachPixel(layer.mean, [&](const Rgb& c) { return matrix * c; });
        if (layer.variance) forEachPixel(*layer.variance, [&](const Rgb& v) { return matrix.ofVariance(v); });
    }
    if (direct) forEachPixel(*direct, [&](const Rgb& c) { return matrix * c; });
    for (std::optional<HalfBuffers>* of : {&halves, &directHalves})
        if (*of)
            for (Image& half : (*of)->halves) forEachPixel(half, [&](const Rgb& c) { return matrix * c; });
    balanceBeauty(beauty, matrix);
}

PictureLayer pictureLayer(const Film& film, const std::string& name, const std::string& part, float scale) {
    const FilmLayer& samples = film.layer(name);
    const PixelRegion& region = film.region();
    PictureLayer layer{name, part, Image(region.width(), region.height()), std::nullopt};
    if (samples.spec().groups > 1) layer.variance.emplace(region.width(), region.height());
    forEachRow(region.height(), [&](int row) {
        for (int column = 0; column < region.width(); ++column) {
            const int x = region.x0 + column, y = region.y0 + row;
            layer.mean.setRgb(column, row, samples.mean(x, y) * scale);
            if (layer.variance) layer.variance->setRgb(column, row, samples.varianceOfMean(x, y) * (scale * scale));
        }
    });
    return layer;
}

HalfBuffers halvesOf(const FilmLayer& layer, float scale) {
    const PixelRegion& region = layer.region();
    HalfBuffers both{{Image(region.width(), region.height()), Image(region.width(), region.height())}};
    forEachRow(region.height(), [&](int row) {
        for (int column = 0; column < region.width(); ++column) {
            const int x = region.x0 + column, y = region.y0 + row;
            for (int g = 0; g < 2; ++g)
                both.halves[g].setRgb(column, row,
                                      (layer.has(x, y, g) ? layer.group(x, y, g) : layer.mean(x, y)) * scale);
        }
    });
    fillUnsampled({&both.halves[0], &both.halves[1]}, layer);
    return both;
}

void addGBufferSpec(std::vector<FilmLayerSpec>& layers, int groups) {
    layers.push_back({.name = kGBufferLayer, .channels = kGBufferChannels, .groups = groups});
}

void addGBufferSample(FilmLayer& layer, int x, int y, const GBufferSample& s, float filterWeight, int group) {
    float values[] = {s.albedo.x, s.albedo.y, s.albedo.z, s.normal.x,
                      s.normal.y, s.normal.z, s.depth,    lengthSquared(s.albedo) + lengthSquared(s.normal)};
    // Otherwise one sample with a NaN from a broken texture would spoil the means of the whole pixel.
    for (float& value : values)
        if (!std::isfinite(value)) value = 0;
    layer.add(x, y, group, values, filterWeight);
}

float alphaAt(const FilmLayer& layer, int x, int y) {
    const double expected = layer.expected(x, y);
    if (expected == 0) return 0;
    const double mean = layer.sum(x, y, 0) / filterDivisor(layer.sum(x, y, 1), expected);
    return float(std::clamp(mean, 0., 1.));
}

Image alphaOf(const FilmLayer& layer) {
    const PixelRegion& region = layer.region();
    Image alpha(region.width(), region.height(), {"A"});
    forEachRow(region.height(), [&](int row) {
        for (int column = 0; column < region.width(); ++column)
            alpha.at(column, row, 0) = alphaAt(layer, region.x0 + column, region.y0 + row);
    });
    return alpha;
}

Image sampleCounts(const FilmLayer& layer) {
    const PixelRegion& region = layer.region();
    Image counts(region.width(), region.height(), {"X"});
    forEachRow(region.height(), [&](int row) {
        for (int column = 0; column < region.width(); ++column)
            counts.at(column, row, 0) = float(layer.expected(region.x0 + column, region.y0 + row));
    });
    return counts;
}

GBuffer gBufferOf(const Film& film, std::optional<int> group) {
    const PixelRegion& region = film.region();
    const int width = region.width(), height = region.height();
    const FilmLayer& samples = film.layer(kGBufferLayer);
    GBuffer g{Image(width, height), Image(width, height, {"X", "Y", "Z"}), Image(width, height, {"Z"})};
    const auto rows = static_cast<size_t>(height);
    std::vector<double> noiseOfRow(rows), sampledInRow(rows);
    forEachRow(height, [&](int row) {
        for (int column = 0; column < width; ++column) {
            const int x = region.x0 + column, y = region.y0 + row;
            if (samples.expected(x, y) == 0) continue;
            const bool ofGroup = group && samples.has(x, y, *group);
            const double expected = ofGroup ? samples.expected(x, y, *group) : samples.expected(x, y);
            const auto sum = [&](int c) { return ofGroup ? samples.sum(x, y, c, *group) : samples.sum(x, y, c); };
            const double divisor = filterDivisor(sum(kGBufferChannels), expected);
            const auto mean = [&](int c) { return float(sum(c) / divisor); };
            for (int c = 0; c < 3; ++c) g.albedo.at(column, row, c) = std::clamp(mean(c), 0.f, 1.f);
            for (int c = 0; c < 3; ++c) g.normal.at(column, row, c) = mean(3 + c);
            g.depth.at(column, row, 0) = mean(6);
            double variance = mean(7);
            for (int c = 0; c < 6; ++c) variance -= double(mean(c)) * double(mean(c));
            // Overestimates the variance of the mean, because it treats the samples as independent although they are
            // stratified. One sample gives no estimate, so 1 is assumed, which counts as noisy.
            noiseOfRow[size_t(row)] += expected < 2 ? 1 : std::max(0.0, variance) / (expected - 1);
            ++sampledInRow[size_t(row)];
        }
    });
    const auto total = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
    if (const double sampled = total(sampledInRow); sampled > 0)
        g.noise = float(std::sqrt(total(noiseOfRow) / sampled));
    fillUnsampled({&g.albedo, &g.normal, &g.depth}, samples);
    return g;
}

}  // namespace drc
