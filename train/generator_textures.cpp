#include "generator_textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace drc::interior {
namespace {

float lattice(int x, int y, uint32_t seed) {
    uint32_t h = seed ^ (static_cast<uint32_t>(x) * 0x8da6b343u) ^ (static_cast<uint32_t>(y) * 0xd8163841u);
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return static_cast<float>((h ^ (h >> 15)) >> 8) * 0x1p-24f;
}

// Value noise on a lattice that repeats after `period` cells, so that textures are tileable.
float noise(float x, float y, int period, uint32_t seed) {
    const float fx = std::floor(x), fy = std::floor(y);
    const auto wrap = [period](float f) {
        const int i = static_cast<int>(f) % period;
        return i < 0 ? i + period : i;
    };
    const int x0 = wrap(fx), x1 = wrap(fx + 1), y0 = wrap(fy), y1 = wrap(fy + 1);
    const auto ease = [](float t) { return t * t * (3 - 2 * t); };
    const float tx = ease(x - fx), ty = ease(y - fy);
    return lerp(ty, lerp(tx, lattice(x0, y0, seed), lattice(x1, y0, seed)),
                lerp(tx, lattice(x0, y1, seed), lattice(x1, y1, seed)));
}

float fractalNoise(float u, float v, int cells, uint32_t seed) {
    float sum = 0, weight = 0.5f;
    for (int octave = 0; octave < 4; ++octave, cells *= 2, weight *= 0.5f) {
        const auto k = static_cast<float>(cells);
        sum += weight * noise(u * k, v * k, cells, seed + static_cast<uint32_t>(octave));
    }
    return sum / 0.9375f;
}

float encodeSrgb(float x) {
    x = std::clamp(x, 0.f, 1.f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

using Shader = std::function<Rgb(float, float)>;

Shader wood(Rng& rng, const Rgb& base) {
    const uint32_t seed = rng.bits();
    const int planks = rng.integer(3, 7);
    const float contrast = rng.uniform(0.15f, 0.6f);
    return [=](float u, float v) {
        const float plank = std::floor(v * static_cast<float>(planks));
        const float inPlank = v * static_cast<float>(planks) - plank;
        const auto shift = lattice(static_cast<int>(plank), 7, seed);
        const float grain = fractalNoise(u + shift, v * 16, 4, seed + static_cast<uint32_t>(plank));
        const float joint = std::abs(u - shift) < 0.004f || inPlank < 0.02f ? 0.35f : 1;
        const float tone = (0.75f + 0.5f * shift) * (1 - contrast + 2 * contrast * grain) * joint;
        return base * tone;
    };
}

Shader stripes(Rng& rng, const Rgb& base) {
    const int count = rng.integer(2, 12);
    const Rgb other = base * rng.uniform(0.3f, 0.85f);
    const float share = rng.uniform(0.2f, 0.7f);
    return [=](float u, float) {
        const float t = u * static_cast<float>(count);
        return t - std::floor(t) < share ? other : base;
    };
}

Shader blotches(Rng& rng, const Rgb& base) {
    const uint32_t seed = rng.bits();
    const int cells = rng.integer(4, 16);
    const float contrast = rng.uniform(0.2f, 0.7f);
    return [=](float u, float v) { return base * (1 + contrast * 2 * (fractalNoise(u, v, cells, seed) - 0.5f)); };
}

Shader bricks(Rng& rng, const Rgb& base) {
    const uint32_t seed = rng.bits();
    const int rows = 2 * rng.integer(3, 5);
    const float mortar = rng.uniform(0.03f, 0.08f);
    return [=](float u, float v) {
        const float row = std::floor(v * static_cast<float>(rows));
        float x = u * static_cast<float>(rows) / 2 + (static_cast<int>(row) % 2 != 0 ? 0.5f : 0);
        const float y = v * static_cast<float>(rows) - row;
        const float column = std::floor(x);
        x -= column;
        if (y < mortar * 2 || x < mortar) return Rgb(0.55f, 0.53f, 0.5f);
        const float tone = 0.7f + 0.5f * lattice(static_cast<int>(column) % (rows / 2), static_cast<int>(row), seed);
        return base * (tone * (0.85f + 0.3f * fractalNoise(u, v, 32, seed)));
    };
}

Shader tiles(Rng& rng, const Rgb& base) {
    const uint32_t seed = rng.bits();
    const int count = rng.integer(2, 5);
    const Rgb grout = base * rng.uniform(0.3f, 1.2f);
    const Rgb other = rng.chance(0.4f) ? base * rng.uniform(0.1f, 0.8f) : base;
    return [=](float u, float v) {
        const float x = u * static_cast<float>(count), y = v * static_cast<float>(count);
        const int i = static_cast<int>(x), j = static_cast<int>(y);
        if (x - std::floor(x) < 0.03f || y - std::floor(y) < 0.03f) return grout;
        return ((i + j) % 2 != 0 ? other : base) * (0.9f + 0.2f * lattice(i, j, seed));
    };
}

Shader floral(Rng& rng, const Rgb& base) {
    const uint32_t seed = rng.bits();
    const int cells = rng.integer(3, 6);
    const Rgb petal{rng.uniform(0.1f, 0.9f), rng.uniform(0.1f, 0.7f), rng.uniform(0.1f, 0.7f)};
    const auto petals = static_cast<float>(rng.integer(3, 7));
    return [=](float u, float v) {
        const float x = u * static_cast<float>(cells), y = v * static_cast<float>(cells);
        const float turn = 6 * lattice(static_cast<int>(x), static_cast<int>(y), seed);
        const float dx = x - std::floor(x) - 0.5f, dy = y - std::floor(y) - 0.5f;
        const float edge = 0.28f + 0.14f * std::cos(petals * std::atan2(dy, dx) + turn);
        return std::sqrt(dx * dx + dy * dy) < edge ? petal : base;
    };
}

Shader painting(Rng& rng, const Rgb& base) {
    struct Blob {
        float x, y, rx, ry;
        bool round;
        Rgb color;
    };
    std::vector<Blob> blobs;
    const int count = rng.integer(4, 24);
    for (int i = 0; i < count; ++i) {
        Blob b{rng.uniform(), rng.uniform(), rng.uniform(0.03f, 0.4f), rng.uniform(0.03f, 0.4f), rng.chance(0.5f), {}};
        b.color = Rgb{rng.uniform(0.02f, 0.9f), rng.uniform(0.02f, 0.9f), rng.uniform(0.02f, 0.9f)};
        blobs.push_back(b);
    }
    const uint32_t seed = rng.bits();
    return [=](float u, float v) {
        Rgb c = base * (0.6f + 0.8f * v);
        for (const Blob& b : blobs) {
            const float x = (u - b.x) / b.rx, y = (v - b.y) / b.ry;
            if (b.round ? x * x + y * y < 1 : std::max(std::abs(x), std::abs(y)) < 1) c = b.color;
        }
        return c * (0.8f + 0.4f * fractalNoise(u, v, 16, seed));
    };
}

Shader leafMask(Rng& rng) {
    const float width = rng.uniform(0.25f, 0.5f), teeth = static_cast<float>(rng.integer(0, 14));
    return [=](float u, float v) {
        const float edge = width * std::sin(kPi * v) * (1 + 0.12f * std::sin(teeth * 2 * kPi * v));
        const float inside = std::abs(u - 0.5f) < edge ? 1.f : 0.f;
        return Rgb(inside, inside, inside);
    };
}

Shader shaderFor(Pattern pattern, Rng& rng, const Rgb& base) {
    switch (pattern) {
        case Pattern::Wood:
            return wood(rng, base);
        case Pattern::Stripes:
            return stripes(rng, base);
        case Pattern::Blotches:
            return blotches(rng, base);
        case Pattern::Bricks:
            return bricks(rng, base);
        case Pattern::Painting:
            return painting(rng, base);
        case Pattern::Tiles:
            return tiles(rng, base);
        case Pattern::Floral:
            return floral(rng, base);
        case Pattern::LeafMask:
            return leafMask(rng);
    }
    return blotches(rng, base);
}

}  // namespace

std::string addImageTexture(Draft& draft, Rng& rng, Pattern pattern, const Rgb& base, float repeats) {
    Texture t;
    t.name = fmt::format("texture{:02}", draft.textures.size());
    t.type = pattern == Pattern::LeafMask ? "float" : "spectrum";
    t.file = fmt::format("textures/{}.tga", t.name);
    t.width = t.height = pattern == Pattern::LeafMask ? 64 : 192;
    t.parameters =
        fmt::format(R"("imagemap" "string filename" [ "{}" ] "float uscale" [ {:.4g} ] "float vscale" [ {:.4g} ])",
                    t.file, repeats, repeats);
    const Shader shade = shaderFor(pattern, rng, base);
    for (int y = 0; y < t.height; ++y) {
        for (int x = 0; x < t.width; ++x) {
            const Rgb c = shade((static_cast<float>(x) + 0.5f) / static_cast<float>(t.width),
                                (static_cast<float>(y) + 0.5f) / static_cast<float>(t.height));
            // Reflectances are at most 0.9, because light in a closed room would otherwise hardly ever be absorbed.
            const float top = pattern == Pattern::LeafMask ? 1 : 0.9f;
            for (int i = 0; i < 3; ++i) {
                t.rgb.push_back(static_cast<uint8_t>(std::lround(255 * encodeSrgb(std::min(c[i], top)))));
            }
        }
    }
    draft.textures.push_back(std::move(t));
    return draft.textures.back().name;
}

std::string addCheckerboard(Draft& draft, const Rgb& a, const Rgb& b, float repeats) {
    Texture t;
    t.name = fmt::format("texture{:02}", draft.textures.size());
    t.type = "spectrum";
    t.parameters = fmt::format(
        R"("checkerboard" "float uscale" [ {:.4g} ] "float vscale" [ {:.4g} ] "rgb tex1" [ {:.4g} {:.4g} {:.4g} ] "rgb tex2" [ {:.4g} {:.4g} {:.4g} ])",
        repeats, repeats, a.x, a.y, a.z, b.x, b.y, b.z);
    draft.textures.push_back(std::move(t));
    return draft.textures.back().name;
}

std::string encodeTga(const Texture& t) {
    std::string bytes(18, '\0');
    bytes[2] = 2;  // true colour, uncompressed
    bytes[12] = static_cast<char>(t.width & 255);
    bytes[13] = static_cast<char>(t.width >> 8);
    bytes[14] = static_cast<char>(t.height & 255);
    bytes[15] = static_cast<char>(t.height >> 8);
    bytes[16] = 24;
    bytes[17] = 0x20;  // rows from the top
    for (size_t i = 0; i + 2 < t.rgb.size(); i += 3) {
        bytes.push_back(static_cast<char>(t.rgb[i + 2]));
        bytes.push_back(static_cast<char>(t.rgb[i + 1]));
        bytes.push_back(static_cast<char>(t.rgb[i]));
    }
    return bytes;
}

}  // namespace drc::interior
