// Where a camera stands while its shutter is open: what all cameras have in common.
#pragma once
#include "math/animated_transform.h"
#include "scene/ray.h"
#include "scene/shutter.h"
#include "scene/turn.h"

namespace drc {

class CameraPlacement {
  public:
    CameraPlacement(const AnimatedTransform& worldToCamera, const Shutter& shutter)
        : shutter_(shutter), toWorld_(worldToCamera.inverse()), inTheMiddle_(toWorld_.at(shutter.motion(0.5f))) {}

    // From o along d, both in camera space and d of any length, at the u-th part of the exposure.
    Ray ray(const Vec3& o, const Vec3& d, float u) const {
        Ray ray;
        ray.time = shutter_.motion(u);
        if (toWorld_.isAnimated())
            place(toWorld_.at(ray.time), o, d, ray);
        else
            place(toWorld_.start(), o, d, ray);
        return ray;
    }

    // To world space, at the time of a ray.
    Transform toWorldAt(float time) const { return toWorld_.isAnimated() ? toWorld_.at(time) : toWorld_.start(); }
    // Whether lengths are the same along all axes, at all times.
    bool keepsAngles() const {
        for (unsigned i = 0, n = toWorld_.steps(); i < n; ++i)
            if (!Turn(toWorldAt(n > 1 ? float(i) / float(n - 1) : 0)).keepsAngles()) return false;
        return true;
    }

    const Shutter& shutter() const { return shutter_; }
    // To world space, in the middle of the exposure.
    const Transform& inTheMiddle() const { return inTheMiddle_; }
    Vec3 position() const { return inTheMiddle_.point(Vec3(0, 0, 0)); }
    Vec3 up() const { return normalize(inTheMiddle_.vector(Vec3(0, 1, 0))); }

  private:
    static void place(const Transform& toWorld, const Vec3& o, const Vec3& d, Ray& ray) {
        ray.o = toWorld.point(o);
        ray.d = normalize(toWorld.vector(d));
    }

    Shutter shutter_;
    AnimatedTransform toWorld_;
    Transform inTheMiddle_;
};

}  // namespace drc
