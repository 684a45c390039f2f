// The surface at the point where a ray hits it. Everything is in world space.
#pragma once
#include "accel/spawn_point.h"
#include "scene/lobes/bsdf.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace drc {

struct SurfaceInteraction {
    Vec3 p{0.f};
    Vec3 wo{0.f};  // unit, towards the ray's origin
    Vec3 ng{0.f};  // geometric normal, unit, as oriented by the shape (one-sided emitters emit on this side)
    Vec3 ns{0.f};  // shading normal, unit, on the side of ng; without bump mapping
    Vec2 uv{0.f};
    Vec3 dpdu{0.f}, dpdv{0.f};
    Vec3 tangent{0.f};  // direction of the shading frame's s: dpdu, unless the mesh has its own tangents
    BumpTangents bumpTangents = BumpTangents::Derivatives;
    float t = 0;          // distance along the ray
    float footprint = 0;  // width of the ray cone at p
    float error = 0;      // see SpawnPoint::error
    float coneSpread = 0;
    float time = 0;      // Ray::time of the ray
    bool moves = false;  // whether the surface moves while the shutter is open
    uint32_t triangle = 0;
    const Primitive* primitive = nullptr;
    const Medium* medium = nullptr;  // of the arriving ray; null: empty space
    // The material's lobes if they are the same everywhere and have been computed in advance; otherwise null.
    const Bsdf* lobes = nullptr;

    TextureContext textureContext() const;
    // The frame `shading` after the material's relief (a bump or normal map) is applied.
    Frame withRelief(const Frame& shading, const Relief& relief, TextureContext at) const;
    // The BSDF at this point; it has no lobes if the material is null or black.
    Bsdf bsdf() const;
    // Le: radiance emitted from p towards wo.
    Rgb emitted() const;
    EmitterHit emitterHit() const { return {p, ng, triangle, uv}; }
    SpawnPoint spawnPoint() const { return {p, ng, footprint, error}; }
    // The medium on the side of the surface to which d points.
    const Medium* mediumTowards(const Vec3& d) const {
        const MediumInterface& media = primitive->media;
        if (!media.changes()) return medium;
        return dot(ng, d) < 0 ? media.inside : media.outside;
    }
    // A ray that leaves p in direction d, with its origin offset from the surface to the side of d. Its cone grows with
    // the given spread, but at least with that of the arriving ray.
    Ray spawnRay(const Vec3& d, float spread) const;
    Ray spawnRay(const Vec3& d) const { return spawnRay(d, coneSpread); }
    // spawnRay() for a specular lobe: marks the ray as mirrored.
    Ray mirroredRay(const Vec3& d) const {
        Ray ray = spawnRay(d);
        ray.mirrored = true;
        return ray;
    }
    // Continues the arriving ray behind p as if there were no surface.
    Ray onward(const Ray& ray) const {
        Ray next = spawnRay(ray.d);
        next.fromCamera = ray.fromCamera;
        next.mirrored = ray.mirrored;
        return next;
    }
};

}  // namespace drc
