// The position and orientation of a camera during the exposure, shared by all cameras.
#pragma once
#include "math/animated_transform.h"
#include "scene/cameras/shutter.h"
#include "scene/lights/turn.h"
#include "scene/ray.h"

namespace drc {

class CameraPlacement {
  public:
    CameraPlacement(const AnimatedTransform& worldToCamera, const Shutter& shutter)
        : shutter_(shutter), toWorld_(worldToCamera.inverse()), inTheMiddle_(toWorld_.at(shutter.motion(0.5f))) {}

    // The world-space ray for origin o and direction d, which are in camera space, d of any length. u: time within the
    // exposure, in [0,1].
    Ray ray(const Vec3& o, const Vec3& d, float u) const {
        Ray ray;
        ray.time = shutter_.motion(u);
        if (toWorld_.isAnimated())
            place(toWorld_.at(ray.time), o, d, ray);
        else
            place(toWorld_.start(), o, d, ray);
        return ray;
    }

    // Camera-to-world transform at a ray's time (Ray::time).
    Transform toWorldAt(float time) const { return toWorld_.isAnimated() ? toWorld_.at(time) : toWorld_.start(); }
    // Whether the transform preserves angles at all times, that is, scales all axes equally.
    bool keepsAngles() const {
        for (unsigned i = 0, n = toWorld_.steps(); i < n; ++i)
            if (!Turn(toWorldAt(n > 1 ? float(i) / float(n - 1) : 0)).keepsAngles()) return false;
        return true;
    }

    const Shutter& shutter() const { return shutter_; }
    // Camera-to-world transform in the middle of the exposure.
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
