// Final gather: paths like those of the path tracer that end in a radiance cache, one bounce or more after the surface
// that the camera sees. Some paths continue past the look-up, to sample the light at that point for the cache.
//
//     camera -> mirrors, smooth glass -> x1 -> x2: answered by the cache, or -> x3, ...
//
// A cache is asked only where its error is not visible (RadianceCache::accepts). It answers for the separable lobes
// (Bsdf::separableLobes); the path then continues through the other lobes, if there are any. With a cache that accepts
// nothing, the result is the path tracer's, up to rounding.
#pragma once
#include <vector>

#include "transport/radiance_cache.h"
#include "transport/radiance_visitor.h"

namespace drc {

class FinalGather {
  public:
    // Counts over many samples, for --stats.
    struct Counts {
        int64_t asked = 0;     // look-ups at points that the cache accepts
        int64_t answered = 0;  // look-ups that the cache answered
        int64_t refused = 0;   // points with separable lobes that the cache does not accept
        void add(const Counts& other) {
            asked += other.asked;
            answered += other.answered;
            refused += other.refused;
        }
    };

    // Inputs of a camera sample (random numbers, cache) and the outputs that it adds to.
    struct Sample {
        Sampler& sampler;
        const RadianceCache& cache;
        float training = 1;                   // factor on the probability that a path trains
        uint64_t seed;                        // of the random decisions at look-ups
        std::vector<CacheDeposit>& deposits;  // new deposits are appended
        Counts& counts;
        SampleParts parts{};  // further outputs
    };

    // Both must outlive this object.
    FinalGather(const DirectLighting& lighting, const PathSettings& settings) : walker_(lighting, settings) {}

    // Radiance that arrives at the ray's origin along the ray. With the probability that the cache asks for, times
    // Sample::training, a path trains the cache: it continues past the look-up and makes deposits.
    Rgb radiance(const Ray& ray, Sample& sample) const;

  private:
    PathWalker walker_;
};

}  // namespace drc
