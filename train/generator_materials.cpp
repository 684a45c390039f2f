#include "generator_materials.h"

#include <fmt/format.h>

#include <algorithm>

#include "generator_textures.h"

namespace drc::interior {
namespace {

std::string rgb(const char* name, const Rgb& c) {
    return fmt::format(R"( "rgb {}" [ {:.4g} {:.4g} {:.4g} ])", name, c.x, c.y, c.z);
}
std::string number(const char* name, float x) { return fmt::format(R"( "float {}" [ {:.4g} ])", name, x); }
std::string textured(const char* name, const std::string& texture) {
    return fmt::format(R"( "texture {}" [ "{}" ])", name, texture);
}
std::string type(const char* name) { return fmt::format(R"("string type" [ "{}" ])", name); }
std::string exactRoughness(float r) {
    return number("uroughness", r) + number("vroughness", r) + R"( "bool remaproughness" [ "false" ])";
}

int add(Draft& draft, std::string parameters, std::string alpha = "") {
    draft.materials.push_back(
        {fmt::format("material{:02}", draft.materials.size()), std::move(parameters), std::move(alpha)});
    return static_cast<int>(draft.materials.size()) - 1;
}

// The parameter for a diffuse colour, constant or textured.
std::string diffuse(Draft& draft, Rng& rng, const Rgb& color, float textureChance, const std::vector<Pattern>& patterns,
                    float repeats) {
    if (!rng.chance(textureChance)) return rgb("Kd", color);
    return textured("Kd", addImageTexture(draft, rng, rng.pick(patterns), color, repeats));
}

// In pbrt's disney material, Kd is called color.
std::string asColor(std::string kd) { return kd.replace(kd.find("Kd"), 2, "color"); }

// A diffuse base under a coat, by one of the models that pbrt files use for it.
int coated(Draft& draft, Rng& rng, const std::string& kd) {
    const float roughness = rng.logUniform(0.02f, 0.4f);
    const float ks = rng.uniform(0.03f, 0.12f);
    const Rgb specular(ks, ks, ks);
    switch (rng.integer(0, 4)) {
        case 0:
        case 1:
            return add(draft, type("substrate") + kd + rgb("Ks", specular) + exactRoughness(roughness));
        case 2:
            return add(draft, type("plastic") + kd + rgb("Ks", specular * 4) + number("roughness", roughness) +
                                  R"( "bool remaproughness" [ "false" ])");
        case 3: {
            const float rough = rng.uniform(0.1f, 0.9f), metallic = rng.chance(0.2f) ? rng.uniform(0.2f, 1) : 0,
                        sheen = rng.chance(0.3f) ? rng.uniform(0, 1) : 0,
                        clearcoat = rng.chance(0.3f) ? rng.uniform(0, 1) : 0;
            return add(draft, type("disney") + asColor(kd) + number("roughness", rough) + number("metallic", metallic) +
                                  number("sheen", sheen) + number("clearcoat", clearcoat));
        }
        default:
            return add(draft, type("uber") + kd + rgb("Ks", specular * 3) + exactRoughness(roughness));
    }
}

int makeMetal(Draft& draft, Rng& rng) {
    struct Conductor {
        Rgb eta, k;
    };
    // RGB averages of measured indices of refraction: gold, copper, aluminium, chromium.
    static const std::vector<Conductor> kConductors = {{{0.143f, 0.375f, 1.442f}, {3.983f, 2.386f, 1.603f}},
                                                       {{0.200f, 0.924f, 1.102f}, {3.913f, 2.453f, 2.142f}},
                                                       {{1.657f, 0.880f, 0.521f}, {9.224f, 6.270f, 4.837f}},
                                                       {{4.370f, 2.917f, 1.655f}, {5.206f, 4.231f, 3.755f}}};
    const Conductor& c = rng.pick(kConductors);
    return add(draft, type("metal") + rgb("eta", c.eta) + rgb("k", c.k) + exactRoughness(rng.logUniform(0.01f, 0.4f)));
}

int makeWall(Draft& draft, Rng& rng) {
    const float kind = rng.uniform();
    const std::vector<Pattern> papers = {Pattern::Stripes, Pattern::Floral, Pattern::Blotches, Pattern::Bricks};
    if (kind < 0.55f) return add(draft, type("matte") + rgb("Kd", randomAlbedo(rng, 0.55f, 0.87f, 0.08f)));
    if (kind < 0.70f) return add(draft, type("matte") + rgb("Kd", randomAlbedo(rng, 0.25f, 0.75f, 0.7f)));
    if (kind < 0.77f) return add(draft, type("matte") + rgb("Kd", randomAlbedo(rng, 0.05f, 0.25f, 0.4f)));
    const Rgb color = randomAlbedo(rng, 0.3f, 0.8f, 0.35f);
    if (kind < 0.93f) return add(draft, type("matte") + diffuse(draft, rng, color, 1, papers, rng.uniform(0.4f, 1.2f)));
    return coated(draft, rng, rgb("Kd", color));
}

int makeFloor(Draft& draft, Rng& rng) {
    const float kind = rng.uniform();
    if (kind < 0.4f) {
        const Rgb tone = Rgb(0.55f, 0.36f, 0.2f) * rng.uniform(0.35f, 1.3f);
        const std::string kd =
            textured("Kd", addImageTexture(draft, rng, Pattern::Wood, tone, rng.uniform(0.5f, 1.2f)));
        return rng.chance(0.7f) ? coated(draft, rng, kd) : add(draft, type("matte") + kd);
    }
    if (kind < 0.6f) {
        const Rgb color = randomAlbedo(rng, 0.2f, 0.8f, 0.25f);
        const std::string kd =
            textured("Kd", addImageTexture(draft, rng, Pattern::Tiles, color, rng.uniform(0.4f, 1.5f)));
        return coated(draft, rng, kd);
    }
    if (kind < 0.7f) {
        const Rgb light = randomAlbedo(rng, 0.5f, 0.85f, 0.15f), dark = randomAlbedo(rng, 0.04f, 0.4f, 0.4f);
        const std::string kd = textured("Kd", addCheckerboard(draft, light, dark, rng.uniform(0.8f, 4)));
        return rng.chance(0.5f) ? coated(draft, rng, kd) : add(draft, type("matte") + kd);
    }
    const Rgb color = randomAlbedo(rng, 0.08f, 0.7f, 0.4f);
    return add(draft, type("matte") + diffuse(draft, rng, color, 0.4f, {Pattern::Blotches, Pattern::Stripes}, 0.7f));
}

int makeTiles(Draft& draft, Rng& rng) {
    const Rgb color = randomAlbedo(rng, 0.25f, 0.87f, rng.chance(0.5f) ? 0.1f : 0.6f);
    const float repeats = rng.uniform(0.8f, 3);
    return coated(draft, rng, textured("Kd", addImageTexture(draft, rng, Pattern::Tiles, color, repeats)));
}

int makeFurniture(Draft& draft, Rng& rng) {
    const float kind = rng.uniform();
    if (kind < 0.4f) {
        const Rgb tone = Rgb(0.5f, 0.33f, 0.18f) * rng.uniform(0.25f, 1.4f);
        const std::string kd = diffuse(draft, rng, tone, 0.6f, {Pattern::Wood}, rng.uniform(0.6f, 2));
        return rng.chance(0.6f) ? coated(draft, rng, kd) : add(draft, type("matte") + kd);
    }
    if (kind < 0.65f) return coated(draft, rng, rgb("Kd", randomAlbedo(rng, 0.03f, 0.85f, 0.3f)));
    if (kind < 0.93f) return add(draft, type("matte") + rgb("Kd", randomAlbedo(rng, 0.05f, 0.85f, 0.5f)));
    return makeMetal(draft, rng);
}

int makeFabric(Draft& draft, Rng& rng) {
    const Rgb color = randomAlbedo(rng, 0.05f, 0.8f, 0.6f);
    std::string parameters =
        type("matte") + diffuse(draft, rng, color, 0.3f, {Pattern::Stripes, Pattern::Blotches, Pattern::Floral}, 2);
    if (rng.chance(0.4f)) parameters += number("sigma", rng.uniform(10, 60));
    return add(draft, parameters);
}

int makeGlass(Draft& draft, Rng& rng) {
    const Rgb white(1, 1, 1);
    const Rgb tint = rng.chance(0.7f) ? white : white - randomAlbedo(rng, 0.02f, 0.4f, 1);
    const std::string rough = rng.chance(0.2f) ? exactRoughness(rng.logUniform(0.02f, 0.4f)) : "";
    return add(draft,
               type("glass") + rgb("Kr", white) + rgb("Kt", tint) + number("index", rng.uniform(1.4f, 1.6f)) + rough);
}

int makeOrnament(Draft& draft, Rng& rng, const Palette& palette) {
    const float kind = rng.uniform();
    if (kind < 0.3f) return coated(draft, rng, rgb("Kd", randomAlbedo(rng, 0.05f, 0.85f, 0.9f)));
    if (kind < 0.5f) return makeMetal(draft, rng);
    if (kind < 0.6f) return palette.mirror;
    if (kind < 0.72f) return palette.glass;
    if (kind < 0.77f) {
        const std::string& a = draft.materials[static_cast<size_t>(palette.metal.front())].name;
        const std::string& b = draft.materials[static_cast<size_t>(palette.furniture.front())].name;
        const float amount = rng.uniform(0.2f, 0.8f);
        return add(draft,
                   type("mix") +
                       fmt::format(R"( "string namedmaterial1" [ "{}" ] "string namedmaterial2" [ "{}" ])", a, b) +
                       rgb("amount", Rgb(amount, amount, amount)));
    }
    return add(draft, type("matte") + diffuse(draft, rng, randomAlbedo(rng, 0.1f, 0.85f, 0.9f), 0.2f,
                                              {Pattern::Stripes, Pattern::Floral, Pattern::Blotches}, 3));
}

int makeTranslucent(Draft& draft, const Rgb& color, float transmit, const std::string& alpha = "") {
    const float reflect = 0.95f - transmit;
    return add(draft,
               type("translucent") + rgb("Kd", color) + rgb("Ks", Rgb(0, 0, 0)) +
                   rgb("reflect", Rgb(reflect, reflect, reflect)) + rgb("transmit", Rgb(transmit, transmit, transmit)),
               alpha);
}

}  // namespace

Rgb randomAlbedo(Rng& rng, float lo, float hi, float saturation) {
    const float value = rng.uniform(lo, hi);
    const float hue = rng.uniform(0, 6);
    const float s = saturation * std::sqrt(rng.uniform());
    const auto channel = [&](float offset) {
        const float k = std::fmod(hue + offset, 6.f);
        const float ramp = std::clamp(std::min(k, 4 - k), 0.f, 1.f);
        return std::clamp(value * (1 - s * ramp), 0.02f, 0.9f);
    };
    return {channel(5), channel(3), channel(1)};
}

int makePainting(Draft& draft, Rng& rng) {
    const Rgb base = randomAlbedo(rng, 0.1f, 0.8f, 0.7f);
    const std::string kd = textured("Kd", addImageTexture(draft, rng, Pattern::Painting, base, 1));
    return rng.chance(0.7f) ? add(draft, type("matte") + kd) : coated(draft, rng, kd);
}

Palette makePalette(Draft& draft, Rng& rng, RoomKind kind) {
    Palette p;
    p.lightBody = add(draft, type("matte") + rgb("Kd", Rgb(0, 0, 0)));
    const bool tiled = kind == RoomKind::Bath || (kind == RoomKind::Kitchen && rng.chance(0.5f));
    p.wall = tiled && rng.chance(0.8f) ? makeTiles(draft, rng) : makeWall(draft, rng);
    p.accentWall = tiled && rng.chance(0.5f) ? makeTiles(draft, rng) : makeWall(draft, rng);
    p.floor = tiled && rng.chance(0.7f) ? makeTiles(draft, rng) : makeFloor(draft, rng);
    p.ceiling = add(draft, type("matte") + rgb("Kd", rng.chance(0.85f) ? randomAlbedo(rng, 0.65f, 0.88f, 0.05f)
                                                                       : randomAlbedo(rng, 0.1f, 0.6f, 0.4f)));
    p.trim = rng.chance(0.6f) ? coated(draft, rng, rgb("Kd", randomAlbedo(rng, 0.6f, 0.88f, 0.05f)))
                              : makeFurniture(draft, rng);
    p.ground = add(draft, type("matte") + rgb("Kd", randomAlbedo(rng, 0.08f, 0.6f, 0.5f)));
    p.glass = makeGlass(draft, rng);
    p.pane = add(draft, type("glass") + rgb("Kr", Rgb(1, 1, 1)) + rgb("Kt", Rgb(1, 1, 1)) + number("index", 1.5f));
    const float silver = rng.uniform(0.8f, 0.98f);
    p.mirror = add(draft, type("mirror") + rgb("Kr", Rgb(silver, silver, silver)));
    p.stem = add(draft, type("matte") + rgb("Kd", Rgb(0.2f, 0.13f, 0.06f)));
    const Rgb green{rng.uniform(0.08f, 0.3f), rng.uniform(0.25f, 0.5f), rng.uniform(0.04f, 0.15f)};
    if (rng.chance(0.6f)) {
        const float transmit = rng.uniform(0.3f, 0.6f);
        p.leaf = makeTranslucent(draft, green, transmit, addImageTexture(draft, rng, Pattern::LeafMask, green, 1));
    } else {
        p.leaf = add(draft, type("matte") + rgb("Kd", green));
    }
    for (int i = rng.integer(2, 4); i > 0; --i) p.furniture.push_back(makeFurniture(draft, rng));
    for (int i = rng.integer(2, 3); i > 0; --i) p.fabric.push_back(makeFabric(draft, rng));
    for (int i = rng.integer(1, 2); i > 0; --i) p.metal.push_back(makeMetal(draft, rng));
    for (int i = rng.integer(5, 8); i > 0; --i) p.ornament.push_back(makeOrnament(draft, rng, p));
    for (int i = 5; i > 0; --i)
        p.paper.push_back(add(draft, type("matte") + rgb("Kd", randomAlbedo(rng, 0.05f, 0.8f, 0.8f))));
    const Rgb cream{0.85f, rng.uniform(0.65f, 0.85f), rng.uniform(0.4f, 0.8f)};
    p.shade.push_back(makeTranslucent(draft, cream, rng.uniform(0.3f, 0.7f)));
    p.shade.push_back(p.metal.front());
    return p;
}

}  // namespace drc::interior
