// The interface of caches in which paths end: the light that the separable lobes of a surface scatter is looked up
// instead of traced.
//
// A cache stores the radiance that these lobes scatter towards a view, divided by the lobes' factor for that view
// (Bsdf::viewFactor). For separable lobes, and only for them, the quotient is the same for all views: it can be shared,
// and becomes exact as the cache's resolution grows. For Lambertian reflection it is the irradiance divided by pi.
#pragma once
#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace drc {

// A vertex of a path at which a cache may be asked. World space.
struct CachePoint {
    Vec3 p;
    Vec3 n;           // geometric normal, unit, on the side from which the path arrives
    float reach = 0;  // see CachePoint::reachOf; world units

    // Width over which paths spread that were sampled with `pdf` per solid angle and travelled `distance`: the side of
    // a square that a cone of solid angle 1 / pdf covers. A cache must not be coarser than this width: where the
    // segment is short (corners, contact shadows) or the sampled lobe is narrow, its error would be visible.
    static float reachOf(float distance, float pdf) { return pdf > 0 ? distance / std::sqrt(pdf) : 0.f; }
};

struct CacheAnswer {
    Rgb perFactor{0.f};  // the radiance that separable lobes scatter at the point, divided by their view factor
    // The probability with which the path should make a deposit, to improve the answer. Set even if there is no answer.
    float training = 0;
};

class RadianceCache {
  public:
    virtual ~RadianceCache() = default;

    // Whether the cache can have values for this point, given enough deposits. The result does not depend on the
    // deposits, so that deposits and look-ups come from the same points.
    virtual bool accepts(const CachePoint& at) const = 0;
    // Prefetches the memory that lookUp will read first.
    virtual void prefetch(const CachePoint& at) const = 0;
    // False: there are too few deposits for an answer. Safe from any number of threads.
    virtual bool lookUp(const CachePoint& at, CacheAnswer& answer) const = 0;
};

// A path's estimate of the light scattered at a point that the cache accepts.
struct CacheDeposit {
    CachePoint at;
    Rgb light;       // scattered by the separable lobes towards the path, an unbiased sample
    Rgb viewFactor;  // cacheableFactor() of these lobes' view factor towards the path
};

// The view factor by which deposits are divided and answers are multiplied: rounded to steps that a cache can sum as
// integers, and at most 4, which textures brighter than white may exceed. The rounding matters little, as long as
// deposits and answers use the same factor.
inline constexpr float kViewFactorSteps = 0x1p13f, kGreatestViewFactor = 4;
inline Rgb cacheableFactor(const Rgb& factor) {
    Rgb f(0.f);
    for (int c = 0; c < 3; ++c)
        if (factor[c] > 0)
            f[c] = std::nearbyint(std::min(factor[c], kGreatestViewFactor) * kViewFactorSteps) / kViewFactorSteps;
    return f;
}

}  // namespace drc
