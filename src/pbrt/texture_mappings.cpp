#include "pbrt/texture_mappings.h"

#include "base/suggest.h"

namespace drc::pbrt {
namespace {

// Only warns, because exporters write the parameters of all mappings.
void warnOfOthers(const ParamSet& texture, const std::string& mapping, std::initializer_list<std::string_view> others) {
    for (const std::string_view name : others)
        if (texture.has(name))
            warn(texture.pos(), "parameter '" + std::string(name) + "' of " + texture.owner() +
                                    " has no effect: its mapping is '" + mapping + "'");
    texture.ignore(others);
}

// pbrt-v4's planes are in texture space, pbrt-v3's in world space. With M p + t the point in texture space: vs . (M p +
// t) = (transposed M vs) . p + vs . t.
Mapping2D planarIn(const Transform& worldToTexture, const Vec3& vs, const Vec3& vt, const Vec2& delta) {
    const Vec3 x = worldToTexture.vector(Vec3(1, 0, 0)), y = worldToTexture.vector(Vec3(0, 1, 0)),
               z = worldToTexture.vector(Vec3(0, 0, 1)), t = worldToTexture.point(Vec3(0, 0, 0));
    const auto turned = [&](const Vec3& v) { return Vec3(dot(x, v), dot(y, v), dot(z, v)); };
    return Mapping2D::planar(turned(vs), turned(vt), delta + Vec2(dot(t, vs), dot(t, vt)));
}

}  // namespace

Mapping2D makeMapping2D(const ParamSet& texture, const Transform& textureToWorld, Dialect dialect, const Vec3& origin) {
    const Transform toFile = Transform::translate(origin);
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
        const Vec3 vs = texture.getVector("v1", Vec3(1, 0, 0)), vt = texture.getVector("v2", Vec3(0, 1, 0));
        const Vec2 delta(texture.getFloat("udelta", 0), texture.getFloat("vdelta", 0));
        warnOfOthers(texture, type, {"uscale", "vscale"});
        return planarIn(dialect == Dialect::V3 ? toFile : textureToWorld.inverse() * toFile, vs, vt, delta);
    }
    if (type == "spherical" || type == "cylindrical") {
        warnOfOthers(texture, type, {"uscale", "vscale", "udelta", "vdelta", "v1", "v2"});
        const Transform worldToTexture = textureToWorld.inverse() * toFile;
        return type == "spherical" ? Mapping2D::spherical(worldToTexture) : Mapping2D::cylindrical(worldToTexture);
    }
    fail(texture.pos(),
         "unknown texture mapping '" + type + "'" + suggestion(type, {"uv", "planar", "spherical", "cylindrical"}));
}

// For solid textures, pbrt-v3 transforms world-space points by the current transformation itself, not by its inverse as
// for 2D mappings. Its scenes are tuned to this: "Scale 10 10 10" makes noise ten times as fine. In pbrt-v4, it makes
// noise ten times as coarse.
Mapping3D makeMapping3D(const Transform& textureToWorld, Dialect dialect, const Vec3& origin) {
    return Mapping3D((dialect == Dialect::V3 ? textureToWorld : textureToWorld.inverse()) *
                     Transform::translate(origin));
}

}  // namespace drc::pbrt
