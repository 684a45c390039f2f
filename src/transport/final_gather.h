// Final gather: paths like those of the path tracer that end in a radiance cache, one bounce or more after the surface
// that the camera sees. Some of them go on beyond that point, to find out for the cache what the light there is.
//
//     camera -> mirrors, smooth glass -> x1 -> x2: answered by the cache, or -> x3, ...
//
// A cache is asked where its error is not seen (RadianceCache::accepts). It answers for the separable lobes
// (Bsdf::separableLobes); the path then continues by the others, if there are any. With a cache that accepts nothing,
// this is the path tracer, to rounding.
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
        int64_t answered = 0;  // of these
        int64_t refused = 0;   // points with separable lobes that it does not accept
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
        uint64_t seed;                        // of the random numbers for look-ups
        std::vector<CacheDeposit>& deposits;  // are appended
        Counts& counts;
        SampleParts parts{};  // what else is wanted
    };

    // Both must outlive this object.
    FinalGather(const DirectLighting& lighting, const PathSettings& settings) : walker_(lighting, settings) {}

    // All light that arrives at the ray's origin along it. A path trains the cache, that is it goes on and makes
    // deposits, with the probability that the cache asks for, times Sample::training.
    Rgb radiance(const Ray& ray, Sample& sample) const;

  private:
    PathWalker walker_;
};

}  // namespace drc
