// Ray queries against a scene, by Embree. Thread-safe after construction.
#pragma once
#include <memory>
#include <optional>

#include "accel/interaction.h"
#include "scene/scene.h"

namespace drc {

class Accel {
  public:
    // Builds on all cores. The scene must outlive the Accel and stay where it is.
    explicit Accel(const Scene& scene);
    ~Accel();
    Accel(const Accel&) = delete;
    Accel& operator=(const Accel&) = delete;

    // Nearest surface along the ray, alpha masks applied. False: the ray escapes.
    bool intersect(const Ray& ray, SurfaceInteraction& hit) const;
    // The same in two steps: find() starts to fetch from memory what describe() reads, so that other work between the
    // two hides the wait.
    struct Found {
        const void* geometry = nullptr;
        const Instance* instance = nullptr;
        uint32_t triangle = 0;
        float b1 = 0, b2 = 0, t = 0;
        // Of a shape, in its own space: kept from when it was found. The same ray, taken there once more with other
        // rounding, may miss. Not of meshes and curves.
        ShapeHit shape;
    };
    bool find(const Ray& ray, Found& found) const;
    void describe(const Ray& ray, const Found& found, SurfaceInteraction& hit) const;
    // True if anything lies between o and o + tMax * d (d unit) at that time, which is a ray's. Surfaces without a
    // material do not block.
    bool occluded(const Vec3& o, const Vec3& d, float tMax, float time) const;
    // Whether anything is not always where it is.
    bool anythingMoves() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace drc
