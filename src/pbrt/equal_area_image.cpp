#include "pbrt/equal_area_image.h"

#include <numbers>

#include "base/parallel.h"

namespace drc::pbrt {
namespace {

constexpr int kSamplesPerSide = 4;  // per pixel of the result

// Nearest-neighbour lookup, because interpolation would blur suns and lamps twice.
const Rgb& nearest(const LightImage& image, const Vec2& uv) {
    return image.at(std::clamp(int(uv.x * float(image.width)), 0, image.width - 1),
                    std::clamp(int(uv.y * float(image.height)), 0, image.height - 1));
}

// Difference of cos(theta) between the upper and the lower edge of a row; proportional to the row's solid angle.
double rowHeight(int row, int rows) {
    const double step = std::numbers::pi / rows;
    return std::cos(row * step) - std::cos((row + 1) * step);
}

}  // namespace

Vec2 equalAreaSquareOf(const Vec3& direction) {
    const Vec3 d = normalize(direction);
    // r = |u| + |v| in the square. Its square is the share of the hemisphere that is nearer to the z axis: 1 - |cos|.
    const float r = std::sqrt(std::max(0.f, 1 - std::abs(d.z)));
    const float turn = std::atan2(std::abs(d.y), std::abs(d.x)) / (0.5f * kPi);  // 0 at x, 1 at y
    float v = turn * r, u = r - v;
    // The lower hemisphere is folded outwards over the sides of the diamond.
    if (d.z < 0) {
        const float inner = u;
        u = 1 - v;
        v = 1 - inner;
    }
    return Vec2(0.5f * (1 + std::copysign(u, d.x)), 0.5f * (1 + std::copysign(v, d.y)));
}

Vec3 equalAreaDirectionOf(const Vec2& uv) {
    const float u = 2 * uv.x - 1, v = 2 * uv.y - 1;
    const float inside = 1 - std::abs(u) - std::abs(v);  // negative outside the diamond
    const float r = 1 - std::abs(inside);
    const float phi = (r == 0 ? 1 : (std::abs(v) - std::abs(u)) / r + 1) * (0.25f * kPi);
    const float s = r * std::sqrt(2 - r * r);  // sine of the angle to the z axis
    return Vec3(s * std::copysign(std::cos(phi), u), s * std::copysign(std::sin(phi), v),
                std::copysign(1 - r * r, inside));
}

LightImage latLongFromEqualArea(const LightImage& square) {
    if (square.empty()) return {};
    LightImage result{2 * square.width, square.height, {}};
    result.texels.resize(size_t(result.width) * size_t(result.height));
    parallelFor(0, result.height, 8, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const double top = std::cos(std::numbers::pi * y / result.height), height = rowHeight(y, result.height);
            for (int x = 0; x < result.width; ++x) {
                Rgb sum(0.f);
                for (int j = 0; j < kSamplesPerSide; ++j) {
                    // Samples are uniform in solid angle.
                    const double cosTheta = top - height * (j + 0.5) / kSamplesPerSide;
                    const double sinTheta = std::sqrt(std::max(0.0, 1 - cosTheta * cosTheta));
                    for (int i = 0; i < kSamplesPerSide; ++i) {
                        const double phi = 2 * std::numbers::pi * (x + (i + 0.5) / kSamplesPerSide) / result.width;
                        sum +=
                            nearest(square, equalAreaSquareOf(Vec3(float(sinTheta * std::cos(phi)),
                                                                   float(sinTheta * std::sin(phi)), float(cosTheta))));
                    }
                }
                result.texels[size_t(y) * size_t(result.width) + size_t(x)] =
                    sum / float(kSamplesPerSide * kSamplesPerSide);
            }
        }
    });
    // A sun of one pixel may get one sample too many or too few. Rescaling preserves the total energy.
    double before[3] = {}, after[3] = {};
    for (const Rgb& c : square.texels)
        for (int k = 0; k < 3; ++k) before[k] += double(c[k]) / double(square.texels.size());
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x)
            for (int k = 0; k < 3; ++k)
                after[k] += double(result.at(x, y)[k]) * rowHeight(y, result.height) / (2.0 * result.width);
    Rgb correction(1.f);
    for (int k = 0; k < 3; ++k)
        if (after[k] > 0) correction[k] = float(before[k] / after[k]);
    for (Rgb& c : result.texels) c *= correction;
    return result;
}

double horizontalIlluminance(const LightImage& square) {
    double sum = 0;
    for (int y = 0; y < square.height; ++y)
        for (int x = 0; x < square.width; ++x) {
            const float z = equalAreaDirectionOf(
                                Vec2((float(x) + 0.5f) / float(square.width), (float(y) + 0.5f) / float(square.height)))
                                .z;
            if (z > 0) sum += double(luminance(square.at(x, y))) * double(z);
        }
    return sum * 4 * std::numbers::pi / (double(square.width) * square.height);
}

LightImage flippedTopToBottom(LightImage image) {
    for (int y = 0; y < image.height / 2; ++y)
        for (int x = 0; x < image.width; ++x)
            std::swap(image.texels[size_t(y) * size_t(image.width) + size_t(x)],
                      image.texels[size_t(image.height - 1 - y) * size_t(image.width) + size_t(x)]);
    return image;
}

}  // namespace drc::pbrt
