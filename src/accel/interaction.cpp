#include "accel/interaction.h"

#include "scene/textures/bump.h"
#include "scene/textures/texture_footprint.h"

namespace drc {
namespace {

// Share of the ray cone's width over which one texture lookup averages. Small, because a pixel has many samples, which
// the pixel filter averages. pbrt divides the width by the square root of the samples per pixel; this is its value at
// 256. A larger share would blur textures visibly without a measurable reduction of noise.
constexpr float kSampleShare = 1 / 16.f;

// Cones with a larger spread, in radians, come from diffuse reflection or cover a texel of a radiance map. Averaging a
// bump map over their width would flatten it and change how much it reflects, so bump maps are evaluated unfiltered
// there. (pbrt drops ray differentials after such a reflection.)
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

Frame SurfaceInteraction::withRelief(const Frame& shading, const Relief& relief, TextureContext at) const {
    if (coneSpread > kWidestForBumps) {
        at.footprint = at.uvFootprint = 0;
        at.dpdx = at.dpdy = Vec3(0.f);
        at.duvdx = at.duvdy = Vec2(0.f);
    }
    if (relief.normals) return normalMapFrame(at, shading, *relief.normals);
    if (bumpTangents == BumpTangents::OppositeUnit) {
        at.dpdu = -shading.s;
        // bumpFrame() orients the normal by cross(dpdu, dpdv): the shading frame decides its sign, not the texture's
        // parametrisation.
        at.dpdv = -shading.t;
    }
    return bumpFrame(at, shading, *relief.heights);
}

Bsdf SurfaceInteraction::bsdf() const {
    Bsdf bsdf(Frame::fromNormalAndTangent(ns, tangent), ng);
    const Material* material = primitive->material.get();
    if (material == nullptr) return bsdf;
    const Relief& relief = material->relief();
    const bool isUneven = relief.heights || relief.normals;
    if (lobes) bsdf.borrowLobes(*lobes);
    if (!lobes || isUneven) {
        const TextureContext context = textureContext();
        if (isUneven) bsdf.setFrame(withRelief(bsdf.frame(), relief, context));
        if (!lobes) material->addLobes(context, Rgb(1.f), bsdf);
    }
    bsdf.bendFor(wo);
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
    ray.medium = mediumTowards(d);
    return ray;
}

}  // namespace drc
