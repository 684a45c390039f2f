#include "pbrt/texture_mappings.h"

#include "pbrt/suggest.h"

namespace drc::pbrt {
namespace {

Vec3 vectorOf(const ParamSet& texture, std::string_view name, const Vec3& fallback) {
    const Param* param = texture.find(name, {ParamType::Vector3});
    if (param == nullptr) return fallback;
    if (param->count() != 1)
        texture.failAt(*param, "must have one value of type 'vector', not " + std::to_string(param->count()));
    return vec3At(param->numbers, 0);
}

// Exporters write every mapping's parameters whatever the mapping is.
void warnOfOthers(const ParamSet& texture, const std::string& mapping, std::initializer_list<std::string_view> others) {
    for (const std::string_view name : others)
        if (texture.has(name))
            warn(texture.pos(), "parameter '" + std::string(name) + "' of " + texture.owner() +
                                    " has no effect: its mapping is '" + mapping + "'");
    texture.ignore(others);
}

}  // namespace

Mapping2D makeMapping2D(const ParamSet& texture, const Transform& textureToWorld) {
    const std::string type = texture.getString("mapping", "uv");
    if (type == "uv") {
        UvMapping mapping;
        mapping.uScale = texture.getFloat("uscale", 1);
        mapping.vScale = texture.getFloat("vscale", 1);
        mapping.uDelta = texture.getFloat("udelta", 0);
        mapping.vDelta = texture.getFloat("vdelta", 0);
        warnOfOthers(texture, type, {"v1", "v2"});
        return mapping;
    }
    if (type == "planar") {
        const Vec3 vs = vectorOf(texture, "v1", Vec3(1, 0, 0)), vt = vectorOf(texture, "v2", Vec3(0, 1, 0));
        const Vec2 delta(texture.getFloat("udelta", 0), texture.getFloat("vdelta", 0));
        warnOfOthers(texture, type, {"uscale", "vscale"});
        return Mapping2D::planar(vs, vt, delta);
    }
    if (type == "spherical" || type == "cylindrical") {
        warnOfOthers(texture, type, {"uscale", "vscale", "udelta", "vdelta", "v1", "v2"});
        const Transform worldToTexture = textureToWorld.inverse();
        return type == "spherical" ? Mapping2D::spherical(worldToTexture) : Mapping2D::cylindrical(worldToTexture);
    }
    fail(texture.pos(),
         "unknown texture mapping '" + type + "'" + suggestion(type, {"uv", "planar", "spherical", "cylindrical"}));
}

// pbrt-v3 applies the current transformation itself to points of the world, not its inverse, as it does for the 2D
// mappings. Its scenes are made to look right that way: "Scale 10 10 10" makes noise ten times as fine.
Mapping3D makeMapping3D(const Transform& textureToWorld) { return Mapping3D(textureToWorld); }

}  // namespace drc::pbrt
