#include "accel/interaction.h"

#include "scene/bump.h"
#include "scene/texture_footprint.h"

namespace drc {
namespace {

// Of a cone's width, what one texture lookup averages over: a pixel has many samples, and its filter averages those.
// pbrt divides by the square root of their number; this is what it does with 256. More would blur beyond what
// the surface shows, and saves no noise that can be measured.
constexpr float kSampleShare = 1 / 16.f;

// Cones that spread by more than this, in radians, come from diffuse reflection or fill a map's texel. Bumps that were
// averaged over their width would be flat, and reflect more than bumps do: they are looked up as they are. (pbrt
// follows no cones after such a reflection.)
constexpr float kWidestForBumps = 0.04f;

}  // namespace

TextureContext SurfaceInteraction::textureContext() const {
    TextureContext c;
    c.p = p;
    c.n = ns;
    c.uv = uv;
    c.dpdu = dpdu;
    c.dpdv = dpdv;
    setFootprint(c, kSampleShare * footprint, ng, wo);
    return c;
}

Frame SurfaceInteraction::bumped(const Frame& shading, const FloatTexture& displacement, TextureContext at) const {
    if (bumpTangents == BumpTangents::OppositeUnit) {
        at.dpdu = -shading.s;
        // In the order of dpdu and dpdv that the normal asks for, whichever the texture's is.
        at.dpdv = -shading.t;
    }
    if (coneSpread > kWidestForBumps) {
        at.footprint = at.uvFootprint = 0;
        at.dpdx = at.dpdy = Vec3(0.f);
        at.duvdx = at.duvdy = Vec2(0.f);
    }
    return bumpFrame(at, shading, displacement);
}

Bsdf SurfaceInteraction::bsdf() const {
    Bsdf bsdf(Frame::fromNormalAndTangent(ns, tangent), ng);
    const Material* material = primitive->material.get();
    if (material == nullptr) return bsdf;
    const FloatTexture* bump = material->bump();
    if (lobes) bsdf.borrowLobes(*lobes);
    if (lobes && bump == nullptr) return bsdf;
    const TextureContext context = textureContext();
    if (bump) bsdf.setFrame(bumped(bsdf.frame(), *bump, context));
    if (lobes == nullptr) material->addLobes(context, Rgb(1.f), bsdf);
    return bsdf;
}

Rgb SurfaceInteraction::emitted() const {
    return primitive->areaLight ? primitive->areaLight->emitted(emitterHit(), wo) : Rgb(0.f);
}

Ray SurfaceInteraction::spawnRay(const Vec3& d, float spread) const {
    Ray ray;
    ray.o = spawnPoint().towards(d);
    ray.d = d;
    ray.time = time;
    ray.coneWidth = footprint;
    ray.coneSpread = std::max(spread, coneSpread);
    return ray;
}

}  // namespace drc
