#include "image/exr_primaries.h"

#include <Imath/ImathMatrix.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "image/color.h"

namespace drc {
namespace {

using Chromaticities = std::array<float, 8>;  // x and y of red, green, blue and white

constexpr Chromaticities kRec709 = {.64f, .33f, .3f, .6f, .15f, .06f, .3127f, .329f};

}  // namespace

std::optional<RgbMatrix> rec709From(const ExrAttribute& chromaticities) {
    Chromaticities c{};
    if (chromaticities.value.size() != sizeof(c)) throw Error("its chromaticities are cut short");
    std::memcpy(c.data(), chromaticities.value.data(), sizeof(c));
    constexpr float kTolerance = 1e-4f;
    const auto isNear = [](float a, float b) { return std::abs(a - b) < kTolerance; };
    if (std::equal(c.begin(), c.end(), kRec709.begin(), isNear)) return std::nullopt;

    const auto z = [&](size_t i) { return 1 - double(c[2 * i]) - double(c[2 * i + 1]); };
    Imath::M33d primaries;
    for (size_t i = 0; i < 3; ++i) {
        primaries[int(i)][0] = double(c[2 * i]);
        primaries[int(i)][1] = double(c[2 * i + 1]);
        primaries[int(i)][2] = z(i);
    }
    const double determinant = primaries.determinant();
    const bool isWhite = c[6] > 0 && c[7] > 0 && z(3) > 0;
    if (!std::isfinite(determinant) || std::abs(determinant) < 1e-6 || !isWhite)
        throw Error(
            fmt::format("its chromaticities ({:g} {:g}, {:g} {:g}, {:g} {:g}, white {:g} {:g}) are no primaries", c[0],
                        c[1], c[2], c[3], c[4], c[5], c[6], c[7]));
    const Imath::V3d white(double(c[6]) / double(c[7]), 1, z(3) / double(c[7]));
    const Imath::V3d scale = white * primaries.inverse();
    const RgbMatrix balance = whiteBalance(xyzToRgb(Vec3(white)));
    RgbMatrix map;
    for (int i = 0; i < 3; ++i) {
        const double s = scale[i];
        const Rgb column =
            balance * xyzToRgb(Vec3(Imath::V3d(primaries[i][0] * s, primaries[i][1] * s, primaries[i][2] * s)));
        for (int row = 0; row < 3; ++row) map.rows[size_t(row)][i] = column[row];
    }
    return map;
}

bool isDataLayer(const std::string& layer) {
    std::string name = layer.substr(layer.rfind('.') + 1);
    for (char& c : name) c = char(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    static constexpr const char* kNames[] = {"n", "ns", "ng", "nn", "p", "pref", "nref", "st", "uv", "z", "id"};
    static constexpr const char* kParts[] = {"normal",   "position", "motion", "vector",
                                             "velocity", "depth",    "crypto", "variance"};
    return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames) ||
           std::any_of(std::begin(kParts), std::end(kParts),
                       [&](const char* part) { return name.find(part) != std::string::npos; });
}

void mapColours(Image& image, const std::string& layer, const RgbMatrix& map) {
    const std::string prefix = layer.empty() ? "" : layer + ".";
    const int r = image.channelIndex(prefix + "R"), g = image.channelIndex(prefix + "G"),
              b = image.channelIndex(prefix + "B");
    if (r < 0 || g < 0 || b < 0) return;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            float* p = image.pixel(x, y);
            const Rgb mapped = map * Rgb(p[r], p[g], p[b]);
            p[r] = mapped.x, p[g] = mapped.y, p[b] = mapped.z;
        }
}

}  // namespace drc
