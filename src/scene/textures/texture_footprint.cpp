#include "scene/textures/texture_footprint.h"

#include "math/frame.h"

namespace drc {
namespace {

// At the horizon the ellipse would be infinite. The limit loses nothing, because no texture filters over a larger ratio
// of the axes.
constexpr float kLeastCosine = 1 / 16.f;

}  // namespace

void setFootprint(TextureContext& at, float width, const Vec3& ng, const Vec3& wo) {
    at.footprint = width;
    at.uvFootprint = 0;
    at.dpdx = at.dpdy = Vec3(0.f);
    at.duvdx = at.duvdy = Vec2(0.f);
    if (!(width > 0)) return;

    Vec3 across = cross(ng, wo);
    const float sine = length(across);
    across = sine > 1e-4f ? across * (1 / sine) : Frame::fromNormal(ng).s;
    at.dpdx = across * width;
    at.dpdy = cross(across, ng) * (width / std::max(absDot(ng, wo), kLeastCosine));

    // Solves d = dpdu * du + dpdv * dv for (du, dv) by least squares; the normal equations have the matrix ((uu, uv),
    // (uv, vv)).
    const float uu = lengthSquared(at.dpdu), uv = dot(at.dpdu, at.dpdv), vv = lengthSquared(at.dpdv);
    const float determinant = uu * vv - uv * uv;
    // If the determinant is mostly rounding error, the footprint's orientation in uv is unknown, and the finest level
    // is the safe choice.
    if (!(determinant > 1e-6f * uu * vv)) return;
    // A unit square of uv covers the area sqrt(determinant) on the surface; the square root of this area is used as the
    // length of a unit of uv. For lookups with a single filter width this is a compromise between blur and aliasing of
    // stretched mappings.
    at.uvFootprint = width / std::sqrt(std::sqrt(determinant));
    const auto uvChange = [&](const Vec3& d) {
        const float u = dot(at.dpdu, d), v = dot(at.dpdv, d);
        return Vec2(vv * u - uv * v, uu * v - uv * u) * (1 / determinant);
    };
    at.duvdx = uvChange(at.dpdx);
    at.duvdy = uvChange(at.dpdy);
}

}  // namespace drc
