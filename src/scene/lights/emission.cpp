#include "scene/lights/emission.h"

#include <array>
#include <cmath>

#include "scene/lights/facet_grids.h"

namespace drc {
namespace {

// Clamps x to [0, 1]. Texture coordinates from a file may be NaN, which becomes 0.
float between0And1(float x) { return x > 0 ? std::min(x, 1.f) : 0.f; }

// The pixels [begin, end) along one axis; `begin` lies in the image. If the image repeats, `end` may exceed the number
// of pixels: the range then wraps around, but covers no pixel twice.
struct PixelRange {
    int begin, end;
};

// The pixels along one axis that bilinear lookups at coordinates in [low, high] read.
PixelRange pixelsOf(float low, float high, int count, bool repeats) {
    if (!repeats) {
        const int first = int(std::floor(between0And1(low) * float(count) - 0.5f));
        const int last = int(std::floor(between0And1(high) * float(count) - 0.5f)) + 1;
        return {std::max(0, first), std::min(count, last + 1)};
    }
    // Padded by one pixel on each side, because lookup() rounds in single precision.
    const double begin = std::floor(double(low) * count - 0.5) - 1, end = std::floor(double(high) * count - 0.5) + 3;
    if (!(end > begin && end - begin < count)) return {0, count};
    const double rest = std::fmod(begin, count);
    const int first = int(rest < 0 ? rest + count : rest);
    return {first, first + int(end - begin)};
}

}  // namespace

EmissionImage::EmissionImage(LightImage image) : image_(std::move(image)), facetGrids_(std::make_unique<FacetGrids>()) {
    image_.mend();
    const size_t stride = size_t(image_.width) + 1;
    sums_.assign(stride * (size_t(image_.height) + 1), 0);
    for (int y = 0; y < image_.height; ++y) {
        double row = 0;
        for (int x = 0; x < image_.width; ++x) {
            row += double(luminance(image_.at(x, y)));
            const size_t corner = (size_t(y) + 1) * stride + size_t(x) + 1;
            sums_[corner] = sums_[corner - stride] + row;
        }
    }
}

EmissionImage::~EmissionImage() = default;

Rgb EmissionImage::lookup(const Vec2& uv) const {
    const auto inside = [&](float x) {
        if (!image_.repeats) return between0And1(x);
        const float turn = x - std::floor(x);
        return turn >= 0 ? turn : 0;  // NaN and infinite coordinates read 0
    };
    return image_.lookup(Vec2(inside(uv.x), inside(uv.y)), false);
}

Rgb EmissionImage::mean() const {
    double sum[3] = {};
    for (const Rgb& texel : image_.texels)
        for (int c = 0; c < 3; ++c) sum[c] += double(texel[c]);
    const double count = double(image_.width) * image_.height;
    return Rgb(float(sum[0] / count), float(sum[1] / count), float(sum[2] / count));
}

double EmissionImage::luminanceOf(int x0, int x1, int y0, int y1) const {
    const auto before = [&](int x, int y) { return sums_[size_t(y) * (size_t(image_.width) + 1) + size_t(x)]; };
    return std::max(0.0, before(x1, y1) - before(x0, y1) - before(x1, y0) + before(x0, y0));
}

double EmissionImage::meanLuminance(const Vec2& low, const Vec2& high) const {
    const PixelRange x = pixelsOf(low.x, high.x, image_.width, image_.repeats);
    const PixelRange y = pixelsOf(low.y, high.y, image_.height, image_.repeats);
    // A range that wraps around has a second part, at the image's beginning.
    double sum = 0;
    const auto parts = [](const PixelRange& range, int count) {
        return std::array{PixelRange{range.begin, std::min(range.end, count)},
                          PixelRange{0, std::max(0, range.end - count)}};
    };
    for (const PixelRange& columns : parts(x, image_.width))
        for (const PixelRange& rows : parts(y, image_.height))
            sum += luminanceOf(columns.begin, columns.end, rows.begin, rows.end);
    return sum / (double(x.end - x.begin) * (y.end - y.begin));
}

Emission emissionOf(const RgbTexture& texture) {
    if (texture.isConstant()) return clampNonNegative(texture.eval({}));
    constexpr int kSize = 512;
    LightImage image;
    image.width = image.height = kSize;
    image.repeats = true;
    image.texels.reserve(size_t(kSize) * kSize);
    TextureContext at;
    at.duvdx = Vec2(1.f / kSize, 0);
    at.duvdy = Vec2(0, 1.f / kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            at.uv = Vec2((float(x) + 0.5f) / kSize, (float(y) + 0.5f) / kSize);
            image.texels.push_back(clampNonNegative(texture.eval(at)));
        }
    return Emission(std::make_shared<const EmissionImage>(std::move(image)), Rgb(1.f));
}

}  // namespace drc
