// The interface of caches in which paths end: what the separable lobes of a surface scatter, looked up instead of
// traced.
//
// A cache holds the radiance that these lobes scatter towards a view, divided by their factor of that view
// (Bsdf::viewFactor). Of separable lobes, and of no others, that quotient is the same for all views: it can be shared,
// and is exact as the cache's resolution grows. For Lambertian reflection it is the irradiance divided by pi.
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

    // The width over which paths spread that were sampled with a pdf per solid angle and went a distance: the side of a
    // square that a cone of solid angle 1 / pdf covers. A cache must not be coarser than that: where the segment is
    // short (corners, contact shadows) or the lobe that sampled it narrow, its error would be seen.
    static float reachOf(float distance, float pdf) { return pdf > 0 ? distance / std::sqrt(pdf) : 0.f; }
};

struct CacheAnswer {
    Rgb perFactor{0.f};  // the radiance that separable lobes scatter at the point, divided by their view factor
    // The probability with which the path should make a deposit, so as to improve the answer. Also without one.
    float training = 0;
};

class RadianceCache {
  public:
    virtual ~RadianceCache() = default;

    // Whether the cache has values for such a point, if it knows enough. Depends on nothing that was deposited, so that
    // deposits and look-ups come from the same points.
    virtual bool accepts(const CachePoint& at) const = 0;
    // Asks the processor for the memory that lookUp will read first.
    virtual void prefetch(const CachePoint& at) const = 0;
    // False: too little is known. Safe from any number of threads.
    virtual bool lookUp(const CachePoint& at, CacheAnswer& answer) const = 0;
};

// A path's estimate of the light scattered at a point that the cache accepts.
struct CacheDeposit {
    CachePoint at;
    Rgb light;       // scattered by the separable lobes towards the path, an unbiased sample
    Rgb viewFactor;  // of these lobes towards the path, cacheableFactor() of it
};

// The view factor that deposits are divided by and answers are multiplied with: in steps that a cache can sum up as
// integers, and at most 4, which textures brighter than white may exceed. Which factor it is matters little, that it is
// the same at both ends matters much.
inline constexpr float kViewFactorSteps = 0x1p13f, kGreatestViewFactor = 4;
inline Rgb cacheableFactor(const Rgb& factor) {
    Rgb f(0.f);
    for (int c = 0; c < 3; ++c)
        if (factor[c] > 0)
            f[c] = std::nearbyint(std::min(factor[c], kGreatestViewFactor) * kViewFactorSteps) / kViewFactorSteps;
    return f;
}

}  // namespace drc
