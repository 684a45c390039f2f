// Ray queries against a scene, using Embree. Thread-safe once constructed.
#pragma once
#include <memory>
#include <optional>

#include "accel/interaction.h"
#include "scene/scene.h"

namespace drc {

class Accel {
  public:
    // Builds the acceleration structures on all cores. The scene must outlive the Accel and must not move in memory.
    // Throws Error if Embree fails or memory is short.
    // earlier: of an earlier frame of an animation; its scene may be gone. Geometries of meshes and shapes that both
    // scenes share are taken over, and so are hierarchies of which all is the same. Otherwise, what stays the same gets
    // a hierarchy of its own, so that in the next frames only what has moved is built anew. Rays find the same surfaces
    // in either case, but for the order of surfaces at the same place.
    explicit Accel(const Scene& scene, std::unique_ptr<Accel> earlier = nullptr);
    ~Accel();
    Accel(Accel&&) noexcept;
    Accel(const Accel&) = delete;
    Accel& operator=(const Accel&) = delete;

    // Finds the nearest surface along the ray, with alpha masks applied. False if the ray escapes.
    bool intersect(const Ray& ray, SurfaceInteraction& hit) const;
    // intersect() in two steps. find() prefetches what describe() reads, so that work done between the two hides the
    // memory latency.
    struct Found {
        const void* geometry = nullptr;
        const Instance* instance = nullptr;
        uint32_t triangle = 0;
        float b1 = 0, b2 = 0, t = 0;
        // The hit on a shape, in the shape's own space, as find() saw it. Transforming the ray again would round
        // differently and might miss. Unused for meshes and curves.
        ShapeHit shape;
    };
    bool find(const Ray& ray, Found& found) const;
    void describe(const Ray& ray, const Found& found, SurfaceInteraction& hit) const;
    // Whether anything blocks the segment from o to o + tMax * d (d unit) at the given time (Ray::time). Surfaces
    // without a material or hidden from diffuse rays do not block.
    bool occluded(const Vec3& o, const Vec3& d, float tMax, float time) const;
    // Whether any object moves while the shutter is open.
    bool anythingMoves() const;
    // Whether any surface has an alpha mask for shadow rays, which occluded() applies and find() does not.
    bool hasShadowMasks() const;
    // Whether any surface is hidden from the camera: find() ignores such surfaces for rays with Ray::fromCamera.
    bool hidesFromCamera() const;
    // Whether any surface is hidden from diffuse rays.
    bool hidesFromDiffuse() const;
    // Whether any surface without a material separates two media.
    bool hasOpenMedia() const;
    // The length to use for a ray of this length in a medium: the length itself or, if infinite, the diagonal of the
    // scene's bounds, as in pbrt.
    float lengthInMedium(float length) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace drc
