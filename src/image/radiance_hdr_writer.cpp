#include "image/radiance_hdr_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/error.h"

namespace drc {
namespace {

using Rgbe = std::array<uint8_t, 4>;

Rgbe rgbeOf(const Rgb& colour) {
    constexpr float kMost = 1.69e38f;  // 255 2^(255 - 136), rounded down
    std::array<float, 3> c{};
    for (int i = 0; i < 3; ++i) c[size_t(i)] = colour[i] > 0 ? std::min(colour[i], kMost) : 0.f;
    const float largest = *std::max_element(c.begin(), c.end());
    constexpr float kLeast = 1e-38f;  // above 2^-128, below which the exponent underflows
    if (largest < kLeast) return {};
    int exponent = 0;
    (void)std::frexp(largest, &exponent);
    // Rounded to nearest; a mantissa of 256 needs the next exponent.
    if (std::lround(std::ldexp(largest, 8 - exponent)) > 255) ++exponent;
    Rgbe pixel{};
    for (size_t i = 0; i < 3; ++i) pixel[i] = uint8_t(std::lround(std::ldexp(c[i], 8 - exponent)));
    pixel[3] = uint8_t(exponent + 128);
    return pixel;
}

// Appends runs of equal bytes and stretches of different bytes; a count above 128 denotes a run.
void appendChannel(std::string& bytes, const std::vector<Rgbe>& row, size_t channel) {
    constexpr size_t kShortestRun = 4, kLongestRun = 127, kLongestStretch = 128;
    const auto runAt = [&](size_t x) {
        size_t n = 1;
        while (x + n < row.size() && n < kLongestRun && row[x + n][channel] == row[x][channel]) ++n;
        return n;
    };
    for (size_t x = 0; x < row.size();) {
        if (const size_t run = runAt(x); run >= kShortestRun) {
            bytes += char(128 + run);
            bytes += char(row[x][channel]);
            x += run;
            continue;
        }
        size_t end = x;
        while (end < row.size() && end - x < kLongestStretch && runAt(end) < kShortestRun) ++end;
        bytes += char(end - x);
        for (; x < end; ++x) bytes += char(row[x][channel]);
    }
}

}  // namespace

std::string encodeRadianceHdr(const Image& linear, const std::string& path) {
    if (linear.empty()) throw Error(fmt::format("cannot write {}: the image is empty", path));
    std::string bytes =
        fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", linear.height(), linear.width());
    const bool hasRuns = linear.width() >= 8 && linear.width() <= 0x7fff;
    std::vector<Rgbe> row(size_t(linear.width()));
    for (int y = 0; y < linear.height(); ++y) {
        for (int x = 0; x < linear.width(); ++x) row[size_t(x)] = rgbeOf(linear.rgb(x, y));
        if (hasRuns) {
            bytes += {char(2), char(2), char(linear.width() >> 8), char(linear.width())};
            for (size_t channel = 0; channel < 4; ++channel) appendChannel(bytes, row, channel);
        } else {
            for (const Rgbe& pixel : row) bytes.append(reinterpret_cast<const char*>(pixel.data()), pixel.size());
        }
    }
    return bytes;
}

}  // namespace drc
