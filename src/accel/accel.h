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
    // True if anything lies between o and o + tMax * d (d unit). Surfaces without a material do not block.
    bool occluded(const Vec3& o, const Vec3& d, float tMax) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace drc
