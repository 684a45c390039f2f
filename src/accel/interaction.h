// What is known of the point where a ray meets a surface. World space throughout.
#pragma once
#include "accel/spawn_point.h"
#include "scene/bsdf.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace drc {

struct SurfaceInteraction {
    Vec3 p{0.f};
    Vec3 wo{0.f};  // unit, back along the ray
    Vec3 ng{0.f};  // geometric normal, unit, oriented by the shape (emitters shine on this side)
    Vec3 ns{0.f};  // shading normal, unit, on the side of ng; not bump-mapped
    Vec2 uv{0.f};
    Vec3 dpdu{0.f}, dpdv{0.f};
    Vec3 tangent{0.f};  // that the shading frame's s goes along: dpdu, unless a mesh has its own
    BumpTangents bumpTangents = BumpTangents::Derivatives;
    float t = 0;          // distance along the ray
    float footprint = 0;  // width of the ray's cone at p
    float largest = 0;    // see SpawnPoint
    float coneSpread = 0;
    float time = 0;      // the ray's
    bool moves = false;  // whether the surface is elsewhere at another time
    uint32_t triangle = 0;
    const Primitive* primitive = nullptr;
    // The material's lobes, if they are the same everywhere and somebody has them ready.
    const Bsdf* lobes = nullptr;

    TextureContext textureContext() const;
    // The shading frame that a bump map makes of another.
    Frame bumped(const Frame& shading, const FloatTexture& displacement, TextureContext at) const;
    // The material's lobes at this point; without lobes if the material is null or black.
    Bsdf bsdf() const;
    // Radiance emitted from here towards wo.
    Rgb emitted() const;
    EmitterHit emitterHit() const { return {p, ng, triangle, uv}; }
    SpawnPoint spawnPoint() const { return {p, ng, footprint, largest}; }
    // Ray that leaves this point in direction d, its origin moved off the surface on the side of d. The cone grows
    // with the given spread: at least the arriving cone's own.
    Ray spawnRay(const Vec3& d, float spread) const;
    Ray spawnRay(const Vec3& d) const { return spawnRay(d, coneSpread); }
};

}  // namespace drc
