#include "scene/textures/mip_pyramid.h"

#include <Imath/half.h>

#include <algorithm>
#include <atomic>

#include "base/error.h"
#include "base/parallel.h"
#include "image/color.h"

namespace drc {
namespace {

using Half = Imath::half;

template <typename T>
constexpr int kChannels = 1;
template <>
constexpr int kChannels<Rgb> = 3;

float channel(float v, int) { return v; }
float channel(const Rgb& v, int c) { return v[c]; }
void setChannel(float& v, int, float x) { v = x; }
void setChannel(Rgb& v, int c, float x) { v[c] = x; }

void assignTexel(float& to, const Rgb& from) { to = luminance(from); }
void assignTexel(Rgb& to, const Rgb& from) { to = from; }

// The two texels along one axis between which a lookup interpolates, and their weights.
struct Taps {
    int i0, i1;
    float w0, w1;
};

Taps taps(float x, int size, ImageWrap wrap) {
    if (!std::isfinite(x)) x = 0;
    // Wrapped or clamped first, so that large coordinates neither overflow an int nor lose their fraction.
    x = wrap == ImageWrap::Repeat ? x - std::floor(x) : std::clamp(x, -1.f, 2.f);
    const float p = x * static_cast<float>(size) - 0.5f;
    const float floor = std::floor(p);
    Taps t;
    t.i0 = static_cast<int>(floor);
    t.i1 = t.i0 + 1;
    t.w1 = p - floor;
    t.w0 = 1 - t.w1;
    const auto outside = [size](int i) { return i < 0 || i >= size; };
    switch (wrap) {
        case ImageWrap::Repeat:
            if (t.i0 < 0) t.i0 += size;
            if (t.i1 >= size) t.i1 -= size;
            break;
        case ImageWrap::Black:
            if (outside(t.i0)) t.w0 = 0;
            if (outside(t.i1)) t.w1 = 0;
            [[fallthrough]];
        case ImageWrap::Clamp:
            t.i0 = std::clamp(t.i0, 0, size - 1);
            t.i1 = std::clamp(t.i1, 0, size - 1);
            break;
    }
    return t;
}

// Calls row(y) for each row of an image, on all cores.
template <typename F>
void forEachRow(int width, int height, const F& row) {
    constexpr int kTexelsTogether = 1 << 15;
    parallelFor(0, height, std::max(1, kTexelsTogether / width), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) row(y);
    });
}

// The value of each byte 0 to 255, decoded to linear.
std::vector<float> byteValues(TexelEncoding encoding) {
    std::vector<float> values(256);
    for (int k = 0; k < 256; ++k) {
        const float plain = static_cast<float>(k) / 255;
        values[size_t(k)] = encoding == TexelEncoding::Srgb ? srgbToLinear(plain) : plain;
    }
    return values;
}

// The integer part of the result is the byte whose entry in byteValues() is nearest to `value`.
float positionAmongBytes(float value, TexelEncoding encoding) {
    return 255 * (encoding == TexelEncoding::Srgb ? srgbEncode(value) : value) + 0.5f;
}

// The texels as bytes, each the index of the texel's value in `values`; empty if some texel has no such value.
template <typename T>
std::vector<uint8_t> toBytes(const Image& image, TexelEncoding encoding, const std::vector<float>& values) {
    constexpr int n = kChannels<T>;
    constexpr float kSame = 2e-6f;
    std::vector<uint8_t> bytes(image.pixelCount() * n);
    std::atomic<bool> isOther{false};
    forEachRow(image.width(), image.height(), [&](int y) {
        if (isOther.load(std::memory_order_relaxed)) return;
        uint8_t* out = &bytes[size_t(y) * size_t(image.width()) * n];
        for (int x = 0; x < image.width(); ++x) {
            T texel;
            assignTexel(texel, image.rgb(x, y));
            for (int c = 0; c < n; ++c) {
                const float v = channel(texel, c), guess = positionAmongBytes(v, encoding);
                const int k = guess >= 0 && guess < 256 ? static_cast<int>(guess) : 0;
                if (!(std::abs(values[size_t(k)] - v) <= kSame)) {
                    isOther.store(true, std::memory_order_relaxed);
                    return;
                }
                *out++ = static_cast<uint8_t>(k);
            }
        }
    });
    if (isOther) return {};
    return bytes;
}

template <typename Stored, typename T>
std::vector<Stored> toStored(const std::vector<T>& texels) {
    std::vector<Stored> stored;
    stored.reserve(texels.size() * kChannels<T>);
    for (const T& texel : texels)
        for (int c = 0; c < kChannels<T>; ++c) stored.push_back(Stored(channel(texel, c)));
    return stored;
}

// The next coarser level of an image whose texels are texel(index). Each new texel is the mean over the area that it
// covers, which includes parts of texels where the size is odd.
template <typename T, typename Texel>
std::vector<T> halved(const Texel& texel, int width, int height, int newWidth, int newHeight) {
    struct Span {
        int first, count;
        float weight[4];
    };
    const auto spans = [](int size, int newSize) {
        std::vector<Span> result(newSize);
        const double step = double(size) / newSize;
        for (int i = 0; i < newSize; ++i) {
            const double begin = i * step, end = (i + 1) * step;
            Span& s = result[i];
            s.first = std::min(int(begin), size - 1);
            s.count = std::clamp(int(std::ceil(end - 1e-9)) - s.first, 1, 4);
            for (int j = 0; j < s.count; ++j)
                s.weight[j] = float((std::min(end, s.first + j + 1.0) - std::max(begin, double(s.first + j))) / step);
        }
        return result;
    };
    const std::vector<Span> xs = spans(width, newWidth), ys = spans(height, newHeight);
    std::vector<T> to(size_t(newWidth) * newHeight, T(0.f));
    forEachRow(newWidth, newHeight, [&](int y) {
        for (int x = 0; x < newWidth; ++x) {
            T sum(0.f);
            for (int j = 0; j < ys[y].count; ++j)
                for (int i = 0; i < xs[x].count; ++i)
                    sum +=
                        texel(size_t(ys[y].first + j) * width + xs[x].first + i) * (ys[y].weight[j] * xs[x].weight[i]);
            to[size_t(y) * newWidth + x] = sum;
        }
    });
    return to;
}

// A filter footprint on the image.
struct Ellipse {
    float length, width;  // full lengths of the major and the minor axis, in texels
    Vec2 along;           // the major axis as a full diameter, in units of s and t
};

// The ellipse with the given conjugate diameters, in units of s and t: a circle mapped by the matrix with these
// columns. Its principal axes are the left singular vectors of the matrix.
Ellipse ellipseWithDiameters(const Vec2& axis0, const Vec2& axis1, int imageWidth, int imageHeight) {
    const Vec2 size(static_cast<float>(imageWidth), static_cast<float>(imageHeight));
    const Vec2 a = axis0 * size, b = axis1 * size;
    const float xx = a.x * a.x + b.x * b.x, xy = a.x * a.y + b.x * b.y, yy = a.y * a.y + b.y * b.y;
    const float mean = 0.5f * (xx + yy), half = 0.5f * (xx - yy);
    const float difference = std::sqrt(half * half + xy * xy);
    const float longest = std::sqrt(mean + difference);
    // Eigenvector of the larger eigenvalue, by whichever of two expressions does not cancel.
    Vec2 direction = half >= 0 ? Vec2(half + difference, xy) : Vec2(xy, difference - half);
    const float norm = direction.length();
    direction = norm > 0 ? direction * (longest / norm) : Vec2(longest, 0);
    return {longest, safeSqrt(mean - difference), direction / size};
}

}  // namespace

float srgbToLinear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

// A level stores its texels in exactly one of the three vectors.
template <typename T>
struct MipPyramid<T>::Level {
    int width = 0, height = 0;
    std::vector<uint8_t> bytes;
    std::vector<Half> halves;
    std::vector<float> floats;
};

template <typename T>
MipPyramid<T>::MipPyramid() = default;
template <typename T>
MipPyramid<T>::MipPyramid(MipPyramid&& other) noexcept = default;
template <typename T>
MipPyramid<T>& MipPyramid<T>::operator=(MipPyramid&& other) noexcept = default;
template <typename T>
MipPyramid<T>::~MipPyramid() = default;

template <typename T>
int MipPyramid<T>::levels() const {
    return static_cast<int>(levels_.size());
}

template <typename T>
int MipPyramid<T>::width() const {
    return levels_.front().width;
}

template <typename T>
int MipPyramid<T>::height() const {
    return levels_.front().height;
}

template <typename T>
size_t MipPyramid<T>::bytes() const {
    size_t sum = 0;
    for (const Level& l : levels_)
        sum += l.bytes.size() + l.halves.size() * sizeof(Half) + l.floats.size() * sizeof(float);
    return sum;
}

template <typename T>
MipPyramid<T>::MipPyramid(const Image& image, TexelEncoding encoding) {
    if (image.empty()) throw Error("texture image is empty");
    int width = image.width(), height = image.height();
    maxResolutionLog2_ = std::log2(static_cast<float>(std::max(width, height)));

    // An 8-bit image may contain the values as stored, or values that the reader has already linearised.
    Level finest;
    finest.width = width;
    finest.height = height;
    const std::vector<float> plain = byteValues(TexelEncoding::Linear), srgb = byteValues(TexelEncoding::Srgb);
    finest.bytes = toBytes<T>(image, TexelEncoding::Linear, plain);
    decode_ = encoding == TexelEncoding::Srgb ? srgb : plain;
    if (finest.bytes.empty() && encoding == TexelEncoding::Linear) {
        finest.bytes = toBytes<T>(image, TexelEncoding::Srgb, srgb);
        decode_ = srgb;
    }
    const bool compact = !finest.bytes.empty();
    if (!compact) {
        decode_.clear();
        finest.floats.resize(image.pixelCount() * kChannels<T>);
        forEachRow(width, height, [&](int y) {
            float* out = &finest.floats[size_t(y) * size_t(width) * kChannels<T>];
            for (int x = 0; x < width; ++x) {
                T texel;
                assignTexel(texel, image.rgb(x, y));
                for (int c = 0; c < kChannels<T>; ++c) {
                    const float v = channel(texel, c);
                    *out++ = encoding == TexelEncoding::Srgb ? srgbToLinear(v) : v;
                }
            }
        });
    }
    levels_.push_back(std::move(finest));

    std::vector<T> texels;  // of the level added last; empty for the finest, which is large and is read in place
    const auto texelOfFinest = [&](size_t i) {
        const Level& from = levels_.front();
        T texel;
        for (int c = 0; c < kChannels<T>; ++c) {
            const size_t at = i * kChannels<T> + size_t(c);
            setChannel(texel, c, compact ? decode_[from.bytes[at]] : from.floats[at]);
        }
        return texel;
    };
    while (width > 1 || height > 1) {
        Level level;
        level.width = std::max(1, width / 2);
        level.height = std::max(1, height / 2);
        if (texels.empty())
            texels = halved<T>(texelOfFinest, width, height, level.width, level.height);
        else
            texels = halved<T>([&](size_t i) { return texels[i]; }, width, height, level.width, level.height);
        width = level.width;
        height = level.height;
        if (compact)
            level.halves = toStored<Half>(texels);
        else
            level.floats = toStored<float>(texels);
        levels_.push_back(std::move(level));
    }
    memory_ = NotedMemory(MemoryUse::Textures, bytes());
}

template <typename T>
T MipPyramid<T>::bilinear(const Level& level, const Vec2& st, ImageWrap wrap) const {
    constexpr int n = kChannels<T>;
    const Taps x = taps(st.x, level.width, wrap);
    const Taps y = taps(1 - st.y, level.height, wrap);
    const size_t row0 = size_t(y.i0) * level.width, row1 = size_t(y.i1) * level.width;
    const size_t at[4] = {(row0 + x.i0) * n, (row0 + x.i1) * n, (row1 + x.i0) * n, (row1 + x.i1) * n};
    const float w[4] = {y.w0 * x.w0, y.w0 * x.w1, y.w1 * x.w0, y.w1 * x.w1};
    T result(0.f);
    const auto gather = [&](const auto& texels, const auto& decode) {
        for (int c = 0; c < n; ++c)
            setChannel(result, c,
                       w[0] * decode(texels[at[0] + c]) + w[1] * decode(texels[at[1] + c]) +
                           w[2] * decode(texels[at[2] + c]) + w[3] * decode(texels[at[3] + c]));
    };
    if (!level.bytes.empty())
        gather(level.bytes, [table = decode_.data()](uint8_t k) { return table[k]; });
    else if (!level.halves.empty())
        gather(level.halves, [](Half h) { return static_cast<float>(h); });
    else
        gather(level.floats, [](float f) { return f; });
    return result;
}

template <typename T>
T MipPyramid<T>::trilinear(const Vec2& st, float level, ImageWrap wrap) const {
    if (!(level > 0)) return bilinear(levels_.front(), st, wrap);
    const int last = levels() - 1;
    if (level >= static_cast<float>(last)) return bilinear(levels_[last], Vec2(0.5f, 0.5f), wrap);
    const int finer = static_cast<int>(level);
    return lerp(level - static_cast<float>(finer), bilinear(levels_[finer], st, wrap),
                bilinear(levels_[finer + 1], st, wrap));
}

template <typename T>
T MipPyramid<T>::lookup(const Vec2& st, float width, ImageWrap wrap) const {
    // The level whose texels are as wide as the filter.
    return trilinear(st, width > 0 ? maxResolutionLog2_ + std::log2(width) : 0, wrap);
}

template <typename T>
T MipPyramid<T>::lookup(const Vec2& st, const Vec2& axis0, const Vec2& axis1, float maxAnisotropy,
                        ImageWrap wrap) const {
    const Ellipse e = ellipseWithDiameters(axis0, axis1, width(), height());
    if (!(e.length > 1)) return bilinear(levels_.front(), st, wrap);
    // The filter is at least a texel wide.
    const float across = std::max({e.width, e.length / maxAnisotropy, 1.f});
    const float level = std::log2(across);
    if (!(level < static_cast<float>(levels() - 1))) return trilinear(st, level, wrap);
    // Ellipses with a ratio of up to 1.25 are treated as round.
    const int count = static_cast<int>(std::ceil(e.length / across - 0.25f));
    if (count <= 1) return trilinear(st, level, wrap);
    // The first and the last lookup touch the ends of the ellipse.
    const Vec2 span = e.along * ((e.length - across) / e.length);
    T sum(0.f);
    for (int i = 0; i < count; ++i)
        sum += trilinear(st + span * (static_cast<float>(i) / static_cast<float>(count - 1) - 0.5f), level, wrap);
    return sum * (1 / static_cast<float>(count));
}

template class MipPyramid<float>;
template class MipPyramid<Rgb>;

}  // namespace drc
