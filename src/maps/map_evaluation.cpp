#include "maps/map_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.h"
#include "image/color.h"
#include "image/ssim.h"

namespace drc {
namespace {

constexpr int kMapsAtATime = 8;
constexpr int kNormalsAside = 8;
constexpr double kWhitePercentile = 0.99;
constexpr double kIrradianceEpsilon = 0.01;

// Each texel's share of the hemisphere's solid angle.
std::vector<double> texelWeights(const MapLayout& layout) {
    std::vector<double> weights;
    double sum = 0;
    for (int i = 0; i < layout.texels(); ++i) sum += weights.emplace_back(layout.solidAngle(i / layout.size()));
    for (double& w : weights) w /= sum;
    return weights;
}

// A grey image of the map's luminance times `exposure`.
Image greyPicture(std::span<const float> radiance, const MapLayout& layout, float exposure) {
    const auto texels = size_t(layout.texels());
    Image picture(layout.size(), layout.size(), {"Y"});
    for (size_t i = 0; i < texels; ++i)
        picture.data()[i] = exposure * luminance(Rgb(radiance[i], radiance[texels + i], radiance[2 * texels + i]));
    return picture;
}

// Irradiance divided by pi for each normal: [normals][3].
std::vector<double> irradiances(std::span<const float> radiance, const MapLayout& layout,
                                std::span<const double> weights) {
    const MapLayout normals(Projection::EqualArea, kNormalsAside);
    const auto texels = size_t(layout.texels());
    const Vec2 centre(0.5f, 0.5f);
    std::vector<Vec3> directions;
    for (int i = 0; i < layout.texels(); ++i)
        directions.push_back(layout.direction(i % layout.size(), i / layout.size(), centre));
    std::vector<double> result;
    for (int k = 0; k < normals.texels(); ++k) {
        const Vec3 n = normals.direction(k % kNormalsAside, k / kNormalsAside, centre);
        double sum[3] = {};
        for (size_t i = 0; i < texels; ++i) {
            const double w = weights[i] * std::max(0.f, dot(n, directions[i]));
            for (size_t c = 0; c < 3; ++c) sum[c] += w * radiance[c * texels + i];
        }
        // Each sum is the mean of L cos over the hemisphere, so irradiance / pi = 2 pi * mean / pi = 2 * mean.
        for (const double s : sum) result.push_back(2 * s);
    }
    return result;
}

MapScores mean(std::span<const ExampleScores> scores, MapScores ExampleScores::*which) {
    MapScores sum;
    for (const ExampleScores& s : scores) {
        sum.l1 += (s.*which).l1;
        sum.ssim += (s.*which).ssim;
        sum.irradiance += (s.*which).irradiance;
    }
    const auto n = double(scores.size());
    return {sum.l1 / n, sum.ssim / n, sum.irradiance / n};
}

}  // namespace

double hemisphereMean(std::span<const float> radiance, const MapLayout& layout) {
    const std::vector<double> weights = texelWeights(layout);
    double sum = 0;
    for (size_t i = 0; i < radiance.size(); ++i) sum += weights[i % weights.size()] * radiance[i];
    return sum / 3;
}

std::vector<float> withMeanOf(std::span<const float> radiance, std::span<const float> target, const MapLayout& layout) {
    std::vector<float> result(radiance.begin(), radiance.end());
    const double have = hemisphereMean(radiance, layout), want = hemisphereMean(target, layout);
    if (have > 0)
        for (float& r : result) r = float(r * (want / have));
    return result;
}

float exposureOf(std::span<const float> target, const MapLayout& layout) {
    std::vector<float> values = greyPicture(target, layout, 1).data();
    std::sort(values.begin(), values.end());
    const float white = values[size_t(kWhitePercentile * double(values.size() - 1))];
    return 1 / (white > 0 ? white : values.back());
}

MapScores scoreMap(std::span<const float> radiance, std::span<const float> target, const MapLayout& layout) {
    const std::vector<double> weights = texelWeights(layout);
    const double unit = hemisphereMean(target, layout);
    MapScores scores;
    for (size_t i = 0; i < radiance.size(); ++i)
        scores.l1 += weights[i % weights.size()] * std::abs(double(radiance[i]) - double(target[i])) / (3 * unit);
    const float exposure = exposureOf(target, layout);
    scores.ssim = ssim(greyPicture(target, layout, exposure), greyPicture(radiance, layout, exposure));
    const std::vector<double> e = irradiances(radiance, layout, weights), t = irradiances(target, layout, weights);
    for (size_t i = 0; i < e.size(); ++i) {
        const double error = (e[i] - t[i]) / unit, reference = t[i] / unit;
        scores.irradiance += error * error / (reference * reference + kIrradianceEpsilon) / double(e.size());
    }
    return scores;
}

std::vector<EvaluatedExample> evaluateMapDenoisers(const ExampleSource& examples,
                                                   std::span<const MapDenoiser* const> mapDenoisers, int inputs) {
    inputs = std::min(inputs, examples.inputs());
    const MapLayout& layout = examples.layout();
    const size_t methods = mapDenoisers.size();
    std::vector<EvaluatedExample> result(size_t(examples.count()));
    // [example][input][method]
    std::vector<ExampleScores> all(result.size() * size_t(inputs) * methods);
    parallelFor(0, examples.count() * inputs, kMapsAtATime, [&](int begin, int end) {
        std::vector<CapturedMap> captured;
        std::vector<std::vector<float>> targets;
        TrainingExample example;
        for (int i = begin; i < end; ++i) {
            examples.load(i / inputs, i % inputs, 1, example);
            captured.push_back(std::move(example.inputs.front()));
            targets.push_back(std::move(example.target));
            if (i % inputs == 0) result[size_t(i / inputs)] = {example.viewpoint, example.film, {}};
        }
        for (size_t m = 0; m < methods; ++m) {
            std::vector<CapturedMap> maps = captured;
            mapDenoisers[m]->denoise(maps, layout);
            for (int i = begin; i < end; ++i) {
                const std::vector<float>& radiance = maps[size_t(i - begin)].radiance;
                const std::vector<float>& target = targets[size_t(i - begin)];
                all[size_t(i) * methods + m] = {scoreMap(radiance, target, layout),
                                                scoreMap(withMeanOf(radiance, target, layout), target, layout)};
            }
        }
    });
    std::vector<ExampleScores> own(static_cast<size_t>(inputs));
    for (size_t i = 0; i < result.size(); ++i)
        for (size_t m = 0; m < methods; ++m) {
            for (size_t k = 0; k < own.size(); ++k) own[k] = all[(i * own.size() + k) * methods + m];
            result[i].scores.push_back({mean(own, &ExampleScores::asRendered), mean(own, &ExampleScores::equalEnergy)});
        }
    return result;
}

}  // namespace drc
