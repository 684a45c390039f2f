// The interface of caches in which paths end: what the broad lobes of a surface scatter, looked up instead of traced.
#pragma once
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
    Rgb perAlbedo{
        0.f};  // the radiance that broad lobes scatter at the point, without emission, divided by their albedo
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

// What a path has found out about a point that the cache accepts.
struct CacheDeposit {
    CachePoint at;
    Rgb light;   // scattered by the broad lobes towards the path, an unbiased sample
    Rgb albedo;  // of the broad lobes towards the path
};

}  // namespace drc
