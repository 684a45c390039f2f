#include "pbrt/dialect.h"

namespace drc::pbrt {
namespace {

using enum Dialect;

struct TypeMark {
    std::string_view directive, type;
    Dialect dialect;
};
constexpr TypeMark kTypes[] = {
    {"Film", "image", V3},
    {"Film", "gbuffer", V4},
    {"Film", "rgb", V4},
    {"Film", "spectral", V4},
    {"Sampler", "02sequence", V3},
    {"Sampler", "lowdiscrepancy", V3},
    {"Sampler", "maxmindist", V3},
    {"Sampler", "random", V3},
    {"Sampler", "independent", V4},
    {"Sampler", "paddedsobol", V4},
    {"Sampler", "pmj02bn", V4},
    {"Sampler", "zsobol", V4},
    {"Integrator", "ao", V3},
    {"Integrator", "directlighting", V3},
    {"Integrator", "whitted", V3},
    {"Integrator", "function", V4},
    {"Integrator", "lightpath", V4},
    {"Integrator", "randomwalk", V4},
    {"Integrator", "simplepath", V4},
    {"Integrator", "simplevolpath", V4},
    {"Camera", "environment", V3},
    {"Camera", "spherical", V4},
    {"Material", "disney", V3},
    {"Material", "fourier", V3},
    {"Material", "glass", V3},
    {"Material", "kdsubsurface", V3},
    {"Material", "matte", V3},
    {"Material", "metal", V3},
    {"Material", "mirror", V3},
    {"Material", "plastic", V3},
    {"Material", "substrate", V3},
    {"Material", "translucent", V3},
    {"Material", "uber", V3},
    {"Material", "coatedconductor", V4},
    {"Material", "coateddiffuse", V4},
    {"Material", "conductor", V4},
    {"Material", "dielectric", V4},
    {"Material", "diffuse", V4},
    {"Material", "diffusetransmission", V4},
    {"Material", "interface", V4},
    {"Material", "measured", V4},
    {"Material", "thindielectric", V4},
    {"LightSource", "exinfinite", V3},
    {"AreaLightSource", "area", V3},
    {"Shape", "cone", V3},
    {"Shape", "heightfield", V3},
    {"Shape", "hyperboloid", V3},
    {"Shape", "nurbs", V3},
    {"Shape", "paraboloid", V3},
    {"Shape", "bilinearmesh", V4},
    {"Texture", "uv", V3},
    {"Texture", "directionmix", V4},
};

// Parameters that belong to one dialect. An empty string matches any word.
struct ParameterMark {
    std::string_view directive, type, typeName, name;
    Dialect dialect;
};
constexpr ParameterMark kParameters[] = {
    {"PixelFilter", "", "", "xwidth", V3},
    {"PixelFilter", "", "", "ywidth", V3},
    {"PixelFilter", "gaussian", "", "alpha", V3},
    {"PixelFilter", "", "", "xradius", V4},
    {"PixelFilter", "", "", "yradius", V4},
    {"PixelFilter", "gaussian", "", "sigma", V4},
    {"Sampler", "", "", "dimensions", V3},
    {"Sampler", "", "", "samplepixelcenter", V3},
    {"Sampler", "", "", "randomization", V4},
    {"Sampler", "", "", "seed", V4},
    {"Integrator", "", "", "lightsamplestrategy", V3},
    {"Integrator", "", "", "pixelbounds", V3},
    {"Integrator", "", "", "lightsampler", V4},
    {"Integrator", "", "", "regularize", V4},
    {"Camera", "perspective", "", "halffov", V3},
    {"Camera", "realistic", "", "simpleweighting", V3},
    {"Camera", "realistic", "", "aperture", V4},
    {"LightSource", "", "", "mapname", V3},
    {"LightSource", "", "", "nsamples", V3},
    {"LightSource", "", "", "samples", V3},
    {"LightSource", "", "rgb", "scale", V3},
    {"LightSource", "", "float", "scale", V4},
    {"LightSource", "", "", "filename", V4},
    {"LightSource", "", "", "illuminance", V4},
    {"LightSource", "", "", "portal", V4},
    {"LightSource", "", "", "power", V4},
    {"AreaLightSource", "", "", "nsamples", V3},
    {"AreaLightSource", "", "", "samples", V3},
    {"AreaLightSource", "", "rgb", "scale", V3},
    {"AreaLightSource", "", "float", "scale", V4},
    {"AreaLightSource", "", "", "filename", V4},
    {"AreaLightSource", "", "", "power", V4},
    {"Texture", "imagemap", "", "gamma", V3},
    {"Texture", "imagemap", "", "trilinear", V3},
    {"Texture", "imagemap", "", "encoding", V4},
    {"Texture", "imagemap", "", "filter", V4},
    {"Texture", "imagemap", "", "invert", V4},
    {"Texture", "scale", "", "tex1", V3},
    {"Texture", "scale", "", "tex2", V3},
    {"Texture", "scale", "", "scale", V4},
    {"Texture", "scale", "", "tex", V4},
    {"Material", "mix", "", "namedmaterial1", V3},
    {"Material", "mix", "", "namedmaterial2", V3},
    {"Material", "mix", "", "materials", V4},
    {"Material", "hair", "", "reflectance", V4},
    {"Material", "", "", "bumpmap", V3},
    {"Material", "", "", "displacement", V4},
    {"Shape", "", "", "shadowalpha", V3},
    {"Shape", "", "", "displacement", V4},
    {"Shape", "", "", "emissionfilename", V4},
    {"", "", "color", "", V3},
    {"", "", "xyz", "", V3},
};

bool covers(std::string_view pattern, std::string_view word) { return pattern.empty() || pattern == word; }

}  // namespace

std::string_view nameOf(Dialect dialect) { return dialect == V3 ? "pbrt-v3" : "pbrt-v4"; }

std::optional<Dialect> dialectOfDirective(std::string_view directive) {
    for (const std::string_view name : {"Attribute", "ColorSpace", "Import", "Option"})
        if (directive == name) return V4;
    return std::nullopt;
}

std::optional<Dialect> dialectOfType(std::string_view directive, std::string_view type) {
    if (directive == "MakeNamedMaterial") directive = "Material";
    for (const TypeMark& mark : kTypes)
        if (mark.directive == directive && mark.type == type) return mark.dialect;
    return std::nullopt;
}

std::optional<Dialect> dialectOfParam(std::string_view directive, std::string_view type, const ParamMark& param) {
    if (directive == "MakeNamedMaterial") directive = "Material";
    for (const ParameterMark& mark : kParameters)
        if (covers(mark.directive, directive) && covers(mark.type, type) && covers(mark.typeName, param.typeName) &&
            covers(mark.name, param.name))
            return mark.dialect;
    // In pbrt-v3, blackbody parameters are pairs of a temperature and a factor.
    if (param.typeName == "blackbody" && param.valueCount > 0) return param.valueCount == 1 ? V4 : V3;
    if (param.typeName == "spectrum")
        for (const std::string_view prefix : {"metal-", "glass-", "stdillum-", "illum-"})
            if (param.firstText.starts_with(prefix)) return V4;
    return std::nullopt;
}

std::string DialectFinding::describe() const {
    std::string result(nameOf(dialect));
    if (word.empty()) return result + ", as no word of it is one that only pbrt-v3 or only pbrt-v4 has";
    return result + ", as " + word + " in line " + std::to_string(where.line) + " of " + where.file + " tells";
}

void checkDialect(const DialectFinding& finding, std::string_view directive, std::string_view type,
                  const SourcePos& pos) {
    const auto dialect = type.empty() ? dialectOfDirective(directive) : dialectOfType(directive, type);
    if (!dialect || *dialect == finding.dialect) return;
    const std::string word(type.empty() ? directive : type);
    fail(pos, "only " + std::string(nameOf(*dialect)) + " has the " + (type.empty() ? "directive '" : "type '") + word +
                  "', but the scene is read as " + finding.describe() + "; write all of it for one of the two");
}

}  // namespace drc::pbrt
