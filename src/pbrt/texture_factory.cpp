#include "pbrt/texture_factory.h"

#include <type_traits>

#include "pbrt/registry.h"
#include "scene/texture_checkerboard.h"
#include "scene/texture_imagemap.h"
#include "scene/texture_mix.h"
#include "scene/texture_scale.h"

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

// What stands for a texture that is not built.
template <typename T>
TexturePtr<T> placeholder() {
    return std::make_shared<ConstantTexture<T>>(T(0.5f));
}

// The 2D mapping of an image or a checkerboard.
UvMapping mappingOf(const TextureRequest& request) {
    const TextureParams& p = request.params;
    const std::string type = p.getString("mapping", "uv");
    UvMapping mapping;
    mapping.uScale = p.getFloat("uscale", 1);
    mapping.vScale = p.getFloat("vscale", 1);
    mapping.uDelta = p.getFloat("udelta", 0);
    mapping.vDelta = p.getFloat("vdelta", 0);
    if (type == "planar" || type == "spherical" || type == "cylindrical") {
        warn(p.own().pos(), "texture mapping '" + type + "' is not supported yet; 'uv' is used");
        p.own().ignore({"v1", "v2"});
    } else if (type != "uv") {
        fail(p.own().pos(),
             "unknown texture mapping '" + type + "'" + suggestion(type, {"uv", "planar", "spherical", "cylindrical"}));
    }
    return mapping;
}

template <typename T>
TexturePtr<T> constant(const TextureRequest& request) {
    return part<T>(request, "value", 1);
}

template <typename T>
TexturePtr<T> scale(const TextureRequest& request) {
    return makeScaleTexture<T>(part<T>(request, "tex1", 1), part<T>(request, "tex2", 1));
}

template <typename T>
TexturePtr<T> mix(const TextureRequest& request) {
    return makeMixTexture<T>(part<T>(request, "tex1", 0), part<T>(request, "tex2", 1),
                             request.params.scalar("amount", 0.5f));
}

template <typename T>
TexturePtr<T> checkerboard(const TextureRequest& request) {
    const ParamSet& own = request.params.own();
    const int dimension = own.getInt("dimension", 2);
    if (dimension != 2 && dimension != 3)
        fail(own.pos(), "a checkerboard has dimension 2 or 3, not " + std::to_string(dimension));
    own.ignore({"aamode"});  // samples do it
    if (dimension == 3) {
        warn(own.pos(), "a checkerboard of dimension 3 is not supported yet; the constant 0.5 is used");
        own.ignoreAll();
        return placeholder<T>();
    }
    return makeCheckerboardTexture<T>(part<T>(request, "tex1", 1), part<T>(request, "tex2", 0), mappingOf(request));
}

ImageWrap wrapOf(const TextureParams& p) {
    const std::string wrap = p.getString("wrap", "repeat");
    if (wrap == "repeat") return ImageWrap::Repeat;
    if (wrap == "black") return ImageWrap::Black;
    if (wrap == "clamp") return ImageWrap::Clamp;
    fail(p.own().pos(), "unknown wrap mode '" + wrap + "'" + suggestion(wrap, {"repeat", "black", "clamp"}));
}

template <typename T>
TexturePtr<T> imageMap(const TextureRequest& request) {
    const TextureParams& p = request.params;
    const Param* name = p.own().find("filename", {ParamType::String});
    if (name == nullptr) fail(p.own().pos(), p.own().owner() + " needs the parameter 'filename' of type 'string'");
    const std::string path = request.files.find(p.getString("filename", ""), name->valuePos, "texture");
    const TexelGamma gamma = !p.own().has("gamma")            ? TexelGamma::FromFile
                             : p.own().getBool("gamma", true) ? TexelGamma::Srgb
                                                              : TexelGamma::Linear;
    ImageMapParams params;
    params.mapping = mappingOf(request);
    params.wrap = wrapOf(p);
    params.scale = p.getFloat("scale", 1);
    params.trilinear = p.getBool("trilinear", false);
    p.own().ignore({"maxanisotropy"});
    if constexpr (std::is_same_v<T, float>)
        return makeImageMap(request.images.scalar(path, gamma, name->valuePos), params);
    else
        return makeImageMap(request.images.color(path, gamma, name->valuePos), params);
}

template <typename T>
using TextureMaker = TexturePtr<T> (*)(const TextureRequest&);
template <typename T>
constexpr Registered<TextureMaker<T>> kTextures[] = {
    {"bilerp", nullptr},       {"checkerboard", checkerboard<T>},
    {"constant", constant<T>}, {"dots", nullptr},
    {"fbm", nullptr},          {"imagemap", imageMap<T>},
    {"marble", nullptr},       {"mix", mix<T>},
    {"ptex", nullptr},         {"scale", scale<T>},
    {"uv", nullptr},           {"windy", nullptr},
    {"wrinkled", nullptr},
};

template <typename T>
TexturePtr<T> make(const std::string& type, const TextureRequest& request) {
    const ParamSet& own = request.params.own();
    const auto maker = findMaker<TextureMaker<T>>(kTextures<T>, "texture", type, own.pos(), "the constant 0.5 is used");
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
