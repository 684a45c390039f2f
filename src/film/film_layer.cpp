#include "film/film_layer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace drc {
namespace {

int64_t saturatingSum(int64_t a, int64_t b) {
    int64_t sum = 0;
    if (!__builtin_add_overflow(a, b, &sum)) return sum;
    return b > 0 ? std::numeric_limits<int64_t>::max() : std::numeric_limits<int64_t>::min();
}

int64_t quanta(double value, double perQuantum) {
    constexpr double kMost = 0x1p62;
    return std::llrint(std::clamp(value * perQuantum, -kMost, kMost));
}

}  // namespace

double radianceQuantum(float scale) {
    const double perScale = scale > 0 && std::isfinite(scale) ? std::log2(1 / double(scale)) : 0;
    return std::exp2(std::clamp(std::round(perScale), -100.0, 100.0) - 24);
}

size_t FilmLayerSpec::bytesPerPixel() const {
    const size_t values = size_t(groups) * (size_t(channels) + (weighted ? 2 : 0));
    return values * (storage == Storage::Exact ? sizeof(int64_t) : sizeof(float));
}

FilmLayer::FilmLayer(const PixelRegion& region, const FilmLayerSpec& spec)
    : perQuantum_(1 / spec.quantum), region_(region), spec_(spec) {
    const size_t values = region.count() * size_t(spec.groups) * recordSize();
    if (exact())
        exact_.resize(values);
    else
        single_.resize(values);
}

void FilmLayer::add(int x, int y, int group, std::span<const float> values, float weight, float importance) {
    const size_t at = record(x, y, group), n = size_t(spec_.channels);
    if (exact()) {
        int64_t* r = &exact_[at];
        for (size_t c = 0; c < n; ++c)
            r[c] = saturatingSum(r[c], quanta(double(values[c]) * double(weight), perQuantum_));
        if (!spec_.weighted) return;
        r[n] = saturatingSum(r[n], quanta(double(weight), perQuantum_));
        r[n + 1] += 1;
        return;
    }
    float* r = &single_[at];
    const float w = importance * weight;
    for (size_t c = 0; c < n; ++c) r[c] += values[c] * w;
    if (!spec_.weighted) return;
    r[n] += w;
    r[n + 1] += importance;
}

void FilmLayer::splat(int x, int y, const Rgb& value) {
    int64_t* r = &exact_[record(x, y, 0)];
    for (int c = 0; c < 3; ++c) {
        const int64_t more = quanta(double(value[c]), perQuantum_);
        const std::atomic_ref sum(r[c]);
        int64_t before = sum.load(std::memory_order_relaxed);
        while (!sum.compare_exchange_weak(before, saturatingSum(before, more), std::memory_order_relaxed)) {
        }
    }
}

double FilmLayer::value(int x, int y, int group, size_t i) const {
    const size_t at = record(x, y, group) + i;
    if (!exact()) return double(single_[at]);
    return i > size_t(spec_.channels) ? double(exact_[at]) : double(exact_[at]) * spec_.quantum;
}

double FilmLayer::expected(int x, int y, int group) const { return value(x, y, group, size_t(spec_.channels) + 1); }

int FilmLayer::groupsWithSamples(int x, int y) const {
    int count = 0;
    for (int g = 0; g < spec_.groups; ++g) count += has(x, y, g);
    return count;
}

double FilmLayer::expected(int x, int y) const {
    double total = 0;
    for (int g = 0; g < spec_.groups; ++g) total += expected(x, y, g);
    return total;
}

double FilmLayer::sum(int x, int y, int channel) const {
    double total = 0;
    for (int g = 0; g < spec_.groups; ++g) total += value(x, y, g, size_t(channel));
    return total;
}

Rgb FilmLayer::group(int x, int y, int group) const {
    const double expects = expected(x, y, group);
    if (expects == 0) return Rgb(0.f);
    const double divisor = filterDivisor(value(x, y, group, size_t(spec_.channels)), expects);
    const auto channel = [&](size_t c) { return float(value(x, y, group, c) / divisor); };
    return Rgb(channel(0), channel(1), channel(2));
}

Rgb FilmLayer::mean(int x, int y) const {
    const double expects = expected(x, y);
    if (expects == 0) return Rgb(0.f);
    const double divisor = filterDivisor(sum(x, y, spec_.channels), expects);
    return Rgb(float(sum(x, y, 0) / divisor), float(sum(x, y, 1) / divisor), float(sum(x, y, 2) / divisor));
}

Rgb FilmLayer::varianceOfMean(int x, int y) const {
    const Rgb all = mean(x, y);
    Rgb squares(0.f);
    double expects = 0;
    int count = 0;
    for (int g = 0; g < spec_.groups; ++g) {
        const double own = expected(x, y, g);
        if (own == 0) continue;
        const Rgb difference = (group(x, y, g) - all) * float(own);
        squares += difference * difference;
        expects += own;
        ++count;
    }
    if (count < 2) return Rgb(0.f);
    return squares * float(double(count) / (double(count - 1) * expects * expects));
}

Image FilmLayer::image(float scale) const {
    Image image(region_.width(), region_.height());
    for (int y = 0; y < region_.height(); ++y)
        for (int x = 0; x < region_.width(); ++x) image.setRgb(x, y, mean(region_.x0 + x, region_.y0 + y) * scale);
    return image;
}

void FilmLayer::add(const FilmLayer& other) {
    for (size_t i = 0; i < exact_.size(); ++i) exact_[i] = saturatingSum(exact_[i], other.exact_[i]);
    for (size_t i = 0; i < single_.size(); ++i) single_[i] += other.single_[i];
}

std::span<std::byte> FilmLayer::row(int y) {
    const size_t begin = record(region_.x0, y, 0),
                 count = size_t(region_.width()) * size_t(spec_.groups) * recordSize();
    if (exact()) return std::as_writable_bytes(std::span(exact_).subspan(begin, count));
    return std::as_writable_bytes(std::span(single_).subspan(begin, count));
}

std::span<const std::byte> FilmLayer::row(int y) const { return const_cast<FilmLayer*>(this)->row(y); }

void FilmLayer::copyRow(const FilmLayer& from, int y) {
    const size_t to = record(region_.x0, y, 0), at = from.record(region_.x0, y, 0);
    const size_t count = size_t(region_.width()) * size_t(spec_.groups) * recordSize();
    if (!exact()) {
        std::copy_n(&from.single_[at], count, &single_[to]);
        return;
    }
    // Other threads may add splats meanwhile. Relaxed atomic loads cost no more than plain ones.
    auto* values = const_cast<int64_t*>(&from.exact_[at]);
    for (size_t i = 0; i < count; ++i) exact_[to + i] = std::atomic_ref(values[i]).load(std::memory_order_relaxed);
}

}  // namespace drc
