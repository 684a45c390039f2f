// Rays for tests.
#pragma once
#include "math/rng.h"
#include "math/warp.h"
#include "scene/ray.h"

namespace drc {

inline Ray rayFrom(const Vec3& o, const Vec3& d, float time = 0) {
    Ray r;
    r.o = o;
    r.d = d;
    r.time = time;
    r.coneSpread = 0.01f;
    return r;
}

// Calls f(ray) for rays at random times, from random origins six units away, towards random points of the cube [-1,
// 1]^3.
template <typename F>
void forManyRays(int count, const F& f) {
    Pcg32 rng(6);
    for (int i = 0; i < count; ++i) {
        const Vec3 o = sampleUniformSphere(rng.nextVec2()) * 6.f;
        const Vec2 a = rng.nextVec2(), b = rng.nextVec2();
        f(rayFrom(o, normalize(Vec3(2 * a.x - 1, 2 * a.y - 1, 2 * b.x - 1) - o), b.y));
    }
}

}  // namespace drc
