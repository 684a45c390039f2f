#include "pbrt/texture_factory.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <type_traits>

#include "base/limits.h"
#include "pbrt/registry.h"
#include "pbrt/texture_mappings.h"
#include "scene/textures/texture_bilerp.h"
#include "scene/textures/texture_checkerboard.h"
#include "scene/textures/texture_convert.h"
#include "scene/textures/texture_direction.h"
#include "scene/textures/texture_dots.h"
#include "scene/textures/texture_imagemap.h"
#include "scene/textures/texture_marble.h"
#include "scene/textures/texture_mix.h"
#include "scene/textures/texture_noise.h"
#include "scene/textures/texture_scale.h"
#include "scene/textures/texture_uv.h"

namespace drc::pbrt {
namespace {

template <typename T>
using TexturePtr = std::shared_ptr<const Texture<T>>;

template <typename T>
TexturePtr<T> part(const TextureRequest& request, std::string_view name, float fallback) {
    if constexpr (std::is_same_v<T, float>)
        return request.params.scalar(name, fallback);
    else
        return request.params.color(name, Rgb(fallback));
}

// Replaces a texture that is not supported.
template <typename T>
TexturePtr<T> placeholder() {
    return std::make_shared<ConstantTexture<T>>(T(0.5f));
}

Mapping2D mapping2DOf(const TextureRequest& request) {
    return makeMapping2D(request.params.own(), request.textureToWorld, request.dialect, request.origin);
}
Mapping3D mapping3DOf(const TextureRequest& request) {
    return makeMapping3D(request.textureToWorld, request.dialect, request.origin);
}

NoiseSum noiseOf(const ParamSet& own) {
    const NoiseSum sum{own.getInt("octaves", 8), own.getFloat("roughness", 0.5f)};
    if (sum.octaves < 1 || sum.octaves > limits::kOctaves)
        fail(own.pos(), own.owner() + " must have 1 to " + std::to_string(limits::kOctaves) + " octaves, not " +
                            std::to_string(sum.octaves));
    return sum;
}

template <typename T>
TexturePtr<T> constant(const TextureRequest& request) {
    return part<T>(request, "value", 1);
}

template <typename T>
TexturePtr<T> scale(const TextureRequest& request) {
    return makeScaleTexture<T>(part<T>(request, "tex1", 1), part<T>(request, "tex2", 1));
}

// Scaling in pbrt-v4, where the second factor is a number.
template <typename T>
TexturePtr<T> scaleV4(const TextureRequest& request) {
    const FloatTexturePtr factor = request.params.scalar("scale", 1);
    if constexpr (std::is_same_v<T, float>)
        return makeScaleTexture<T>(part<T>(request, "tex", 1), factor);
    else
        return makeScaleTexture<T>(part<T>(request, "tex", 1), makeGreyTexture(factor));
}

template <typename T>
TexturePtr<T> mix(const TextureRequest& request) {
    return makeMixTexture<T>(part<T>(request, "tex1", 0), part<T>(request, "tex2", 1),
                             request.params.scalar("amount", 0.5f));
}

template <typename T>
TexturePtr<T> directionMix(const TextureRequest& request) {
    const ParamSet& own = request.params.own();
    const Vec3 direction = request.textureToWorld.vector(own.getVector("dir", Vec3(0, 1, 0)));
    if (!(lengthSquared(direction) > 0)) fail(own.pos(), "the 'dir' of " + own.owner() + " must not be zero");
    // The arguments are swapped because the amount weights the first texture here, and the second one in
    // makeMixTexture().
    return makeMixTexture<T>(part<T>(request, "tex2", 1), part<T>(request, "tex1", 0), makeDirectionTexture(direction));
}

CheckerboardEdges edgesOf(const ParamSet& own) {
    const std::string mode = own.getString("aamode", "closedform");
    if (mode == "closedform") return CheckerboardEdges::Averaged;
    if (mode == "none") return CheckerboardEdges::Sharp;
    fail(own.pos(), "unknown antialiasing mode '" + mode + "'" + suggestion(mode, {"closedform", "none"}));
}

template <typename T>
TexturePtr<T> checkerboard(const TextureRequest& request) {
    const ParamSet& own = request.params.own();
    const int dimension = own.getInt("dimension", 2);
    if (dimension != 2 && dimension != 3)
        fail(own.pos(), "a checkerboard has dimension 2 or 3, not " + std::to_string(dimension));
    const TexturePtr<T> a = part<T>(request, "tex1", 1), b = part<T>(request, "tex2", 0);
    const CheckerboardEdges edges = edgesOf(own);
    if (dimension == 3) return makeSolidCheckerboardTexture<T>(a, b, mapping3DOf(request));
    return makeCheckerboardTexture<T>(a, b, mapping2DOf(request), edges);
}

// Both versions of pbrt swap the two parameters by mistake: "inside" is the colour around the dots. Scenes are tuned to
// this.
template <typename T>
TexturePtr<T> dots(const TextureRequest& request) {
    return makeDotsTexture<T>(part<T>(request, "outside", 0), part<T>(request, "inside", 1), mapping2DOf(request));
}

template <typename T>
TexturePtr<T> bilerp(const TextureRequest& request) {
    const auto corner = [&](std::string_view name, float fallback) -> T {
        if constexpr (std::is_same_v<T, float>)
            return request.params.own().getFloat(name, fallback);
        else
            return request.params.own().getColor(name, Rgb(fallback));
    };
    return makeBilerpTexture<T>({corner("v00", 0), corner("v01", 1), corner("v10", 0), corner("v11", 1)},
                                mapping2DOf(request));
}

template <typename T>
TexturePtr<T> fbmTexture(const TextureRequest& request) {
    return makeFbmTexture<T>(noiseOf(request.params.own()), mapping3DOf(request));
}

template <typename T>
TexturePtr<T> wrinkled(const TextureRequest& request) {
    return makeWrinkledTexture<T>(noiseOf(request.params.own()), mapping3DOf(request));
}

template <typename T>
TexturePtr<T> windy(const TextureRequest& request) {
    return makeWindyTexture<T>(mapping3DOf(request));
}

// Fails for textures that exist in pbrt only as colours, not as float textures.
[[noreturn]] void failForNumbers(const TextureRequest& request, const std::string& type) {
    const ParamSet& own = request.params.own();
    fail(own.pos(), own.owner() + " must be of type 'spectrum': '" + type + "' gives colours, not numbers");
}

template <typename T>
TexturePtr<T> uv(const TextureRequest& request) {
    if constexpr (std::is_same_v<T, float>)
        failForNumbers(request, "uv");
    else
        return makeUvTexture(mapping2DOf(request));
}

template <typename T>
TexturePtr<T> marble(const TextureRequest& request) {
    if constexpr (std::is_same_v<T, float>) {
        failForNumbers(request, "marble");
    } else {
        const ParamSet& own = request.params.own();
        const NoiseSum noise = noiseOf(own);
        const float scale = own.getFloat("scale", 1), variation = own.getFloat("variation", 0.2f);
        return makeMarbleTexture({noise, scale, variation}, mapping3DOf(request));
    }
}

ImageWrap wrapOf(const TextureParams& p) {
    const std::string wrap = p.getString("wrap", "repeat");
    if (wrap == "repeat") return ImageWrap::Repeat;
    if (wrap == "black") return ImageWrap::Black;
    if (wrap == "clamp") return ImageWrap::Clamp;
    if (wrap == "octahedralsphere") {
        warn(p.own().pos(), "the wrap mode 'octahedralsphere' is not supported yet; 'repeat' is used");
        return ImageWrap::Repeat;
    }
    fail(p.own().pos(), "unknown wrap mode '" + wrap + "'" + suggestion(wrap, {"repeat", "black", "clamp"}));
}

TexelGamma gammaOf(const ParamSet& own) {
    if (own.find("gamma", {ParamType::Bool}) == nullptr) return TexelGamma::FromFile;
    return own.getBool("gamma", true) ? TexelGamma::Srgb : TexelGamma::Linear;
}

// The power in an encoding such as "gamma 2.2"; none for encodings of another form.
std::optional<float> powerOf(std::string_view encoding) {
    constexpr std::string_view kGamma = "gamma ";
    if (!encoding.starts_with(kGamma)) return {};
    encoding.remove_prefix(std::min(encoding.find_first_not_of(' ', kGamma.size()), encoding.size()));
    float power = 0;
    const auto [end, error] = std::from_chars(encoding.data(), encoding.data() + encoding.size(), power);
    const bool isNumber = error == std::errc() && end == encoding.data() + encoding.size();
    return isNumber && power > 0 && std::isfinite(power) ? std::optional(power) : std::nullopt;
}

// pbrt-v4's encoding, which applies to images that store integers; other images are linear.
TexelReading readingV4(const ParamSet& own) {
    TexelReading how{.number = ColorNumber::MeanOrAlpha};
    const std::string encoding = own.getString("encoding", "sRGB");
    if (encoding == "sRGB") return how;
    if (encoding == "linear") {
        how.gamma = TexelGamma::Linear;
        return how;
    }
    const std::optional<float> power = powerOf(encoding);
    if (!power)
        fail(own.find("encoding", {ParamType::String})->valuePos,
             "the 'encoding' of " + own.owner() +
                 " must be 'sRGB', 'linear' or 'gamma' with a positive number, as in 'gamma 2.2', not '" + encoding +
                 "'");
    how.power = *power;
    return how;
}

// Whether to filter trilinearly. Every look-up is filtered over the footprint of the ray cone anyway: 'point',
// 'bilinear' (pbrt-v4's default) and 'EWA' converge to the same picture.
bool isTrilinear(const ParamSet& own) {
    const std::string filter = own.getString("filter", "bilinear");
    if (filter != "point" && filter != "bilinear" && filter != "trilinear" && filter != "EWA" && filter != "ewa")
        fail(own.find("filter", {ParamType::String})->valuePos,
             "unknown texture filter '" + filter + "'" + suggestion(filter, {"point", "bilinear", "trilinear", "EWA"}));
    return filter == "trilinear";
}

template <typename T>
TexturePtr<T> imageMap(const TextureRequest& request) {
    const TextureParams& p = request.params;
    const Param& name = p.own().needFile("filename");
    const std::string path = request.files.find(name.strings[0], name.valuePos, "texture");
    const bool v4 = request.dialect == Dialect::V4;
    const TexelReading how = v4 ? readingV4(p.own()) : TexelReading{.gamma = gammaOf(p.own())};
    ImageMapParams params;
    params.mapping = mapping2DOf(request);
    params.wrap = wrapOf(p);
    params.scale = p.getFloat("scale", 1);
    params.trilinear = v4 ? isTrilinear(p.own()) : p.getBool("trilinear", false);
    params.maxAnisotropy = p.getFloat("maxanisotropy", 8);
    if (!(params.maxAnisotropy >= 1))
        fail(p.own().pos(), "the 'maxanisotropy' of " + p.own().owner() + " must be at least 1");
    if (params.maxAnisotropy > limits::kAnisotropy) {
        warn(p.own().find("maxanisotropy", {ParamType::Float})->valuePos,
             fmt::format("a 'maxanisotropy' of more than {:g} is rendered as that", limits::kAnisotropy));
        params.maxAnisotropy = limits::kAnisotropy;
    }
    TexturePtr<T> texture;
    if constexpr (std::is_same_v<T, float>)
        texture = makeImageMap(request.images.scalar(path, how, name.valuePos), params);
    else
        texture = makeImageMap(request.images.color(path, how, name.valuePos), params);
    return v4 && p.getBool("invert", false) ? makeInvertedTexture<T>(texture) : texture;
}

template <typename T>
using TextureMaker = TexturePtr<T> (*)(const TextureRequest&);
template <typename T>
constexpr Registered<TextureMaker<T>> kTextures[] = {
    {"bilerp", bilerp<T>},
    {"checkerboard", checkerboard<T>},
    {"constant", constant<T>},
    {"dots", dots<T>},
    {"fbm", fbmTexture<T>},
    {"imagemap", imageMap<T>},
    {"marble", marble<T>},
    {"mix", mix<T>},
    {"ptex", nullptr},
    {"scale", scale<T>},
    {"uv", uv<T>},
    {"windy", windy<T>},
    {"wrinkled", wrinkled<T>},
};

template <typename T>
constexpr Registered<TextureMaker<T>> kTexturesV4[] = {
    {"bilerp", bilerp<T>},     {"checkerboard", checkerboard<T>},
    {"constant", constant<T>}, {"directionmix", directionMix<T>},
    {"dots", dots<T>},         {"fbm", fbmTexture<T>},
    {"imagemap", imageMap<T>}, {"marble", marble<T>},
    {"mix", mix<T>},           {"ptex", nullptr},
    {"scale", scaleV4<T>},     {"windy", windy<T>},
    {"wrinkled", wrinkled<T>},
};

template <typename T>
TexturePtr<T> make(const std::string& type, const TextureRequest& request) {
    const ParamSet& own = request.params.own();
    const std::span<const Registered<TextureMaker<T>>> table =
        request.dialect == Dialect::V3 ? std::span(kTextures<T>) : std::span(kTexturesV4<T>);
    const auto maker = findMaker<TextureMaker<T>>(table, "texture", type, own.pos(), "the constant 0.5 is used");
    if (maker != nullptr) return maker(request);
    own.ignoreAll();
    return placeholder<T>();
}

}  // namespace

FloatTexturePtr makeFloatTexture(const std::string& type, const TextureRequest& request) {
    return make<float>(type, request);
}

RgbTexturePtr makeRgbTexture(const std::string& type, const TextureRequest& request) {
    return make<Rgb>(type, request);
}

}  // namespace drc::pbrt
