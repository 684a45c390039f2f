#include "image/cross_error.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "image/block_means.h"
#include "image/relative_norm.h"
#include "image/relmse.h"

namespace drc {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Indices of the floor(0.1 %) of the pixels with the largest values. NaN is left out.
std::vector<size_t> outliers(const std::vector<float>& distances) {
    std::vector<size_t> order;
    for (size_t i = 0; i < distances.size(); ++i)
        if (!std::isnan(distances[i])) order.push_back(i);
    const auto count = std::ptrdiff_t(double(order.size()) * kRelMseDropped);
    std::partial_sort(order.begin(), order.begin() + count, order.end(), [&](size_t a, size_t b) {
        return distances[a] != distances[b] ? distances[a] > distances[b] : a < b;
    });
    order.resize(size_t(count));
    return order;
}

double mean(const Plane& plane) {
    double sum = 0, count = 0;
    for (const float value : plane.values)
        if (!std::isnan(value)) sum += value, ++count;
    return sum / count;  // 0 / 0 is NaN
}

}  // namespace

Plane relativeProducts(const Image& a, const Image& b, const Image& c, const Image& d, const Image& norm) {
    Plane products(a.width(), a.height());
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const Rgb pa = a.rgb(x, y), pb = b.rgb(x, y), pc = c.rgb(x, y), pd = d.rgb(x, y), n = norm.rgb(x, y);
            double sum = 0;
            for (int i = 0; i < 3; ++i)
                sum += (double(pa[i]) - pb[i]) * (double(pc[i]) - pd[i]) / (double(n[i]) * n[i] + kRelativeNormOffset);
            products.at(x, y) = std::isfinite(sum) ? float(sum / 3) : kNan;
        }
    return products;
}

double referenceNoise(const Image& first, const Image& second, const Image& norm) {
    return mean(relativeProducts(first, second, first, second, norm)) / 2;
}

CrossErrors crossErrors(const Image& first, const Image& second, const Image& norm, const Image& test) {
    requireSameSize(first, second);
    requireSameSize(first, test);
    requireSameSize(first, norm);
    CrossErrors result;
    // A pixel that is not finite in one picture is set to NaN in all three, so that block means cover the same pixels.
    Image r1 = first.toRgb(), r2 = second.toRgb(), t = test.toRgb();
    std::array<double, 3> sumR{}, sumT{};
    for (int y = 0; y < t.height(); ++y)
        for (int x = 0; x < t.width(); ++x) {
            const std::array<Rgb, 3> colors{r1.rgb(x, y), r2.rgb(x, y), t.rgb(x, y)};
            bool finite = true;
            for (size_t i = 0; i < 3; ++i)
                if (!isFinite(colors[i])) finite = false, ++result.nonFinite[i];
            if (!finite) {
                for (Image* image : {&r1, &r2, &t}) image->setRgb(x, y, Rgb(kNan));
                continue;
            }
            for (int c = 0; c < 3; ++c) {
                sumR[size_t(c)] += (double(colors[0][c]) + colors[1][c]) / 2;
                sumT[size_t(c)] += colors[2][c];
            }
        }
    for (size_t c = 0; c < 3; ++c) result.meanRatio[c] = sumR[c] == sumT[c] ? 1 : sumT[c] / sumR[c];

    const int side = tileSide(t.width(), t.height());
    Plane products = relativeProducts(t, r1, t, r2, norm);
    result.error = meanOverTiles(products, side);
    result.noise = referenceNoise(r1, r2, norm);
    if (std::isnan(result.error.mean)) result.meanRatio.fill(kNan);
    for (const size_t i : outliers(relativeProducts(t, norm, t, norm, norm).values)) products.values[i] = kNan;
    result.trimmed = meanOverTiles(products, side);

    const Image b1 = blockMeans(r1, kComparedBlock), b2 = blockMeans(r2, kComparedBlock);
    const Image bt = blockMeans(t, kComparedBlock);
    const Image bn = relativeNorm(b1, b2, kBlockRing);
    result.block = meanOverTiles(relativeProducts(bt, b1, bt, b2, bn), std::max(1, side / kComparedBlock));
    result.blockNoise = referenceNoise(b1, b2, bn);
    return result;
}

}  // namespace drc
