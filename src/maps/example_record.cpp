#include "maps/example_record.h"

#include <Imath/half.h>
#include <zstd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <span>

#include "base/error.h"

namespace drc {
namespace {

static_assert(std::endian::native == std::endian::little, "records are little endian");

// Compression level 19 makes records 3 to 5 % smaller than level 3, but is eighty times slower.
constexpr int kCompressionLevel = 3;
constexpr float kSnorm = 32767, kUnorm = 255;
constexpr int kHalfExponent = 14;  // scales the largest value to [2^14, 2^15), well below the largest half, 65504

bool allFinite(std::span<const float> values) {
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

bool isLight(std::span<const float> values) {
    return allFinite(values) && std::all_of(values.begin(), values.end(), [](float v) { return v >= 0; });
}

// The unit in which values are stored as halves: a power of two, so that scaling itself does not round.
float unitOf(std::span<const float> values) {
    float largest = 0;
    for (const float v : values) largest = std::max(largest, v);
    if (!(largest > 0)) return 1;
    return std::ldexp(1.f, std::max(std::ilogb(largest) - kHalfExponent, std::numeric_limits<float>::min_exponent - 1));
}

class Packer {
  public:
    template <typename T>
    void number(T value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    void vec(const Vec3& v) {
        for (int c = 0; c < 3; ++c) number(v[c]);
    }
    template <typename F>
    void words(std::span<const float> values, const F& word) {
        for (const float v : values) number(uint16_t(word(v)));
    }
    // Only distances may be negative; this means that the ray hit nothing. They are stored as -1, whatever the unit.
    void halves(std::span<const float> values) {
        const float unit = unitOf(values);
        number(unit);
        words(values, [&](float v) { return imath_float_to_half(v < 0 ? -1.f : v / unit); });
    }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

class Unpacker {
  public:
    explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
    template <typename T>
    T number() {
        T value;
        std::memcpy(&value, bytes_.data(), sizeof(value));
        bytes_.remove_prefix(sizeof(value));
        return value;
    }
    Vec3 vec() {
        Vec3 v;
        for (int c = 0; c < 3; ++c) v[c] = number<float>();
        return v;
    }
    template <typename F>
    void words(size_t n, std::vector<float>& values, const F& value) {
        values.resize(n);
        for (float& v : values) v = value(number<uint16_t>());
    }
    void halves(size_t n, std::vector<float>& values) {
        const auto unit = number<float>();
        words(n, values, [unit](uint16_t w) {
            const float v = imath_half_to_float(w);
            return v < 0 ? -1.f : v * unit;
        });
    }
    void skip(size_t n) { bytes_.remove_prefix(n); }

  private:
    std::string_view bytes_;
};

constexpr size_t kSiteBytes = 14 * 4;
size_t inputBytes(const MapLayout& layout) { return 3 * 4 + (2 * 10 + 3) * size_t(layout.texels()); }
size_t exampleBytes(const MapLayout& layout, int inputs) {
    return kSiteBytes + size_t(inputs) * inputBytes(layout) + 2 * (4 + 2 * 3 * size_t(layout.texels()));
}

void packSite(const TrainingExample& example, Packer& to) {
    to.number(uint32_t(example.viewpoint));
    to.number(uint32_t(example.bounces));
    to.number(example.film.x);
    to.number(example.film.y);
    to.number(example.time.value_or(std::numeric_limits<float>::quiet_NaN()));
    const CapturedMap& map = example.inputs.front();
    to.vec(map.origin);
    to.vec(map.frame.n);
    to.vec(map.frame.s);
}

// The inverse of unpackExample().
std::string packExample(const TrainingExample& example) {
    Packer to;
    packSite(example, to);
    for (const CapturedMap& input : example.inputs) {
        to.halves(input.radiance);
        to.words(input.normal,
                 [](float v) { return uint16_t(int16_t(std::lround(std::clamp(v, -1.f, 1.f) * kSnorm))); });
        to.halves(input.distance);
        for (const float v : input.albedo) to.number(uint8_t(std::lround(std::clamp(v, 0.f, 1.f) * kUnorm)));
        to.halves(input.direct);
    }
    to.halves(example.target);
    to.halves(example.targetDeviation.empty() ? std::vector<float>(example.target.size()) : example.targetDeviation);
    return to.bytes();
}

void unpackExample(std::string_view bytes, const MapLayout& layout, int inputs, int first, int count,
                   TrainingExample& example) {
    Unpacker from(bytes);
    const auto texels = size_t(layout.texels());
    example.viewpoint = int(from.number<uint32_t>());
    example.bounces = int(from.number<uint32_t>());
    example.film.x = from.number<float>();
    example.film.y = from.number<float>();
    const auto time = from.number<float>();
    example.time = std::isnan(time) ? std::nullopt : std::optional(time);
    const Vec3 origin = from.vec(), n = from.vec(), s = from.vec();
    example.inputs.resize(size_t(count));
    from.skip(size_t(first) * inputBytes(layout));
    for (CapturedMap& input : example.inputs) {
        input.origin = origin;
        input.frame = Frame(s, cross(n, s), n);
        input.deviation.clear();
        from.halves(3 * texels, input.radiance);
        from.words(3 * texels, input.normal, [](uint16_t w) { return std::max(-1.f, float(int16_t(w)) / kSnorm); });
        from.halves(texels, input.distance);
        input.albedo.resize(3 * texels);
        for (float& v : input.albedo) v = float(from.number<uint8_t>()) / kUnorm;
        from.halves(3 * texels, input.direct);
    }
    from.skip(size_t(inputs - first - count) * inputBytes(layout));
    from.halves(3 * texels, example.target);
    from.halves(3 * texels, example.targetDeviation);
}

}  // namespace

bool isSound(const TrainingExample& example) {
    const auto sound = [](const CapturedMap& map) {
        return isLight(map.radiance) && allFinite(map.normal) && allFinite(map.distance) && allFinite(map.albedo) &&
               isLight(map.direct);
    };
    return std::all_of(example.inputs.begin(), example.inputs.end(), sound) && isLight(example.target) &&
           isLight(example.targetDeviation) &&
           std::any_of(example.target.begin(), example.target.end(), [](float v) { return v > 0; });
}

std::string encodeExample(const TrainingExample& example, const MapLayout& layout) {
    if (!isSound(example))
        throw Error("the example cannot be stored: it has negative or non-finite radiance, or a black target");
    const std::string plain = packExample(example);
    if (plain.size() != exampleBytes(layout, int(example.inputs.size())))
        throw Error("the example's maps differ in size from those of its shard");
    struct Free {
        void operator()(ZSTD_CCtx* c) const { ZSTD_freeCCtx(c); }
    };
    thread_local const std::unique_ptr<ZSTD_CCtx, Free> context(ZSTD_createCCtx());
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kCompressionLevel);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
    std::string record(ZSTD_compressBound(plain.size()), '\0');
    const size_t size = ZSTD_compress2(context.get(), record.data(), record.size(), plain.data(), plain.size());
    if (ZSTD_isError(size)) throw Error(std::string("zstd: ") + ZSTD_getErrorName(size));
    record.resize(size);
    return record;
}

void decodeExample(std::string_view record, const MapLayout& layout, int inputs, int first, int count,
                   TrainingExample& example) {
    const size_t size = exampleBytes(layout, inputs);
    if (ZSTD_getFrameContentSize(record.data(), record.size()) != size)
        throw Error("the record is damaged, or its maps differ in size from those of its shard");
    struct Free {
        void operator()(ZSTD_DCtx* c) const { ZSTD_freeDCtx(c); }
    };
    thread_local const std::unique_ptr<ZSTD_DCtx, Free> context(ZSTD_createDCtx());
    thread_local std::string plain;
    plain.resize(size);
    const size_t got = ZSTD_decompressDCtx(context.get(), plain.data(), size, record.data(), record.size());
    if (ZSTD_isError(got) || got != size) throw Error("the record is damaged");
    unpackExample(plain, layout, inputs, first, count, example);
    if (!isSound(example)) throw Error("the record has negative or non-finite radiance, or a black target");
}

}  // namespace drc
