#include "image/flicker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "image/block_means.h"
#include "image/color.h"
#include "image/relative_norm.h"
#include "image/surface_match.h"
#include "image/view_transform.h"

namespace drc {
namespace {

// Takes differences from a frame to the next one at the points that both show; NaN elsewhere.
class Steps {
  public:
    Steps(const FrameSurfaces& now, const FrameSurfaces& next) : matches_(now.albedo.pixelCount()) {
        const SurfaceMatch match(now, next);
        const int width = now.albedo.width();
        parallelFor(0, now.albedo.height(), 4, [&](int begin, int end) {
            for (int y = begin; y < end; ++y)
                for (int x = 0; x < width; ++x) matches_[size_t(y) * size_t(width) + size_t(x)] = match.at(x, y);
        });
    }

    Image of(const Image& image, const Image& next) const {
        requireSameSize(image, next);
        Image steps(image.width(), image.height());
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const MatchedPixels& match = matches_[size_t(y) * size_t(image.width()) + size_t(x)];
                Rgb sum(0.f);
                for (int i = 0; i < match.count; ++i) {
                    const MatchedPixels::Pixel& pixel = match.pixels[size_t(i)];
                    sum += next.rgb(pixel.x, pixel.y) * pixel.weight;
                }
                constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
                steps.setRgb(x, y, match.count > 0 ? sum - image.rgb(x, y) : Rgb(kUnknown));
            }
        return steps;
    }
    double compared() const {
        const auto shown = std::ranges::count_if(matches_, [](const MatchedPixels& m) { return m.count > 0; });
        return double(shown) / double(matches_.size());
    }

  private:
    std::vector<MatchedPixels> matches_;
};

// The value below which a share of the values lies.
double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

// As an sRGB display shows it, in [0, 1].
Image displayed(const Image& linear, float exposure) {
    Image image = viewed(linear, View::Srgb, exposure);
    for (float& value : image.data()) value = srgbEncode(value);
    return image;
}

}  // namespace

Flicker flickerBetween(const FramePair& pair, const Image& test, const Image& nextTest, float exposure) {
    const Steps steps(pair.surfaces, pair.nextSurfaces);
    const Image first = steps.of(pair.first, pair.nextFirst), second = steps.of(pair.second, pair.nextSecond),
                its = steps.of(test, nextTest);
    const int side = tileSide(its.width(), its.height());
    Flicker result;
    result.compared = steps.compared();
    result.pixels =
        meanOverTiles(relativeProducts(its, first, its, second, relativeNorm(pair.first, pair.second)), side);
    // Blocks are of the pixels that are compared.
    const auto blocks = [](const Image& image) { return blockMeans(image, kComparedBlock); };
    const Image norm = relativeNorm(blocks(pair.first), blocks(pair.second), kBlockRing);
    result.blocks = meanOverTiles(relativeProducts(blocks(its), blocks(first), blocks(its), blocks(second), norm),
                                  std::max(1, side / kComparedBlock));
    const Image shown = steps.of(displayed(test, exposure), displayed(nextTest, exposure));
    std::vector<double> sizes;
    for (int y = 0; y < shown.height(); ++y)
        for (int x = 0; x < shown.width(); ++x) {
            const Rgb step = shown.rgb(x, y);
            if (isFinite(step))
                sizes.push_back(255 * double(std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)})));
        }
    result.medianStep = quantile(sizes, 0.5);
    result.percentile99 = quantile(sizes, 0.99);
    return result;
}

Flicker meanFlicker(const std::vector<Flicker>& pairs) {
    Flicker mean;
    const auto n = double(pairs.size());
    const auto over = [&](Estimate Flicker::*member) {
        double sum = 0, squares = 0;
        for (const Flicker& pair : pairs) {
            sum += (pair.*member).mean;
            squares += std::pow((pair.*member).standardError, 2);
        }
        return Estimate{sum / n, std::sqrt(squares) / n};
    };
    mean.pixels = over(&Flicker::pixels);
    mean.blocks = over(&Flicker::blocks);
    for (const Flicker& pair : pairs) {
        mean.medianStep += pair.medianStep / n;
        mean.percentile99 += pair.percentile99 / n;
        mean.compared += pair.compared / n;
    }
    return mean;
}

}  // namespace drc
