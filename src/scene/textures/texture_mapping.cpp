#include "scene/textures/texture_mapping.h"

namespace drc {
namespace {

constexpr float kInv2Pi = 0.5f * kInvPi;
// The azimuth has no derivative on the axis; this bound keeps it finite.
constexpr float kLeastSquare = 1e-12f;

// A position relative to the texture's origin, with terms that both mappings around the z axis use.
struct AboutAxis {
    Vec3 p;
    float axisSquared;    // squared distance from the axis
    float originSquared;  // squared distance from the origin

    explicit AboutAxis(const Vec3& point)
        : p(point),
          axisSquared(std::max(p.x * p.x + p.y * p.y, kLeastSquare)),
          originSquared(axisSquared + p.z * p.z) {}
    // Derivatives in the direction d: of the azimuth about the z axis, of the polar angle to the z axis, and of the z
    // component of the direction from the origin. Being exact, they are not affected by the seam of the azimuth, across
    // which a finite difference would jump.
    float changeOfAngleAboutAxis(const Vec3& d) const { return (p.x * d.y - p.y * d.x) / axisSquared; }
    float changeOfAngleToAxis(const Vec3& d) const {
        return (p.z * (p.x * d.x + p.y * d.y) - axisSquared * d.z) / (originSquared * std::sqrt(axisSquared));
    }
    float changeOfDirectionsZ(const Vec3& d) const {
        return (d.z - p.z * dot(p, d) / originSquared) / std::sqrt(originSquared);
    }
};

}  // namespace

Mapping2D Mapping2D::spherical(const Transform& worldToTexture) {
    Mapping2D m;
    m.kind_ = Kind::Spherical;
    m.worldToTexture_ = worldToTexture;
    return m;
}

Mapping2D Mapping2D::cylindrical(const Transform& worldToTexture) {
    Mapping2D m;
    m.kind_ = Kind::Cylindrical;
    m.worldToTexture_ = worldToTexture;
    return m;
}

Mapping2D Mapping2D::planar(const Vec3& vs, const Vec3& vt, const Vec2& delta) {
    Mapping2D m({1, 1, delta.x, delta.y});
    m.kind_ = Kind::Planar;
    m.vs_ = vs;
    m.vt_ = vt;
    return m;
}

PlanePoint Mapping2D::at(const TextureContext& c) const {
    switch (kind_) {
        case Kind::Uv:
            break;
        case Kind::Spherical:
            return sphericalPoint(c);
        case Kind::Cylindrical:
            return cylindricalPoint(c);
        case Kind::Planar:
            return planarPoint(c);
    }
    const Vec2 scale(uv_.uScale, uv_.vScale);
    return {c.uv * scale + Vec2(uv_.uDelta, uv_.vDelta), c.duvdx * scale, c.duvdy * scale};
}

PlanePoint Mapping2D::sphericalPoint(const TextureContext& c) const {
    const AboutAxis from(worldToTexture_.point(c.p));
    const Vec3& p = from.p;
    const float about = std::atan2(p.y, p.x);
    const auto change = [&](const Vec3& dp) {
        const Vec3 d = worldToTexture_.vector(dp);
        return Vec2(from.changeOfAngleToAxis(d) * kInvPi, from.changeOfAngleAboutAxis(d) * kInv2Pi);
    };
    return {Vec2(std::atan2(std::sqrt(p.x * p.x + p.y * p.y), p.z) * kInvPi,
                 (about < 0 ? about + 2 * kPi : about) * kInv2Pi),
            change(c.dpdx), change(c.dpdy)};
}

PlanePoint Mapping2D::cylindricalPoint(const TextureContext& c) const {
    const AboutAxis from(worldToTexture_.point(c.p));
    const Vec3& p = from.p;
    const auto change = [&](const Vec3& dp) {
        const Vec3 d = worldToTexture_.vector(dp);
        return Vec2(from.changeOfAngleAboutAxis(d) * kInv2Pi, from.changeOfDirectionsZ(d));
    };
    return {Vec2((kPi + std::atan2(p.y, p.x)) * kInv2Pi, p.z / std::sqrt(from.originSquared)), change(c.dpdx),
            change(c.dpdy)};
}

PlanePoint Mapping2D::planarPoint(const TextureContext& c) const {
    return {Vec2(uv_.uDelta + dot(c.p, vs_), uv_.vDelta + dot(c.p, vt_)), Vec2(dot(c.dpdx, vs_), dot(c.dpdx, vt_)),
            Vec2(dot(c.dpdy, vs_), dot(c.dpdy, vt_))};
}

SolidPoint Mapping3D::at(const TextureContext& c) const {
    return {worldToTexture_.point(c.p), worldToTexture_.vector(c.dpdx), worldToTexture_.vector(c.dpdy)};
}

}  // namespace drc
