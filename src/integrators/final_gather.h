// Final gather: paths like those of the path tracer that end in a radiance cache, one bounce or more after the surface
// that the camera sees. Some of them go on beyond that point, to find out for the cache what the light there is.
//
//     camera -> mirrors, smooth glass -> x1 -> x2: answered by the cache, or -> x3, ...
//
// A cache is asked where its error is not seen (RadianceCache::accepts). It answers for the broad lobes; the path then
// continues by the others, if there are any. With a cache that accepts nothing, this is the path tracer, to rounding.
#pragma once
#include <vector>

#include "integrators/path_walker.h"
#include "integrators/radiance_cache.h"

namespace drc {

class FinalGather {
  public:
    // Lobes whose alpha is at least this are broad here: their light hardly depends on the direction from which it is
    // seen, so that paths from all directions can share it.
    static constexpr float kBroadAlpha = 0.5f;

    // Counts over many samples, for --stats.
    struct Counts {
        int64_t asked = 0;     // look-ups at points that the cache accepts
        int64_t answered = 0;  // of these
        int64_t refused = 0;   // points with broad lobes that it does not accept
        int64_t hits = 0;      // of the camera, see Splitting
        int64_t lights = 0;    // light samples there
        int64_t rays = 0;      // gather rays from there
        void add(const Counts& other) {
            asked += other.asked;
            answered += other.answered;
            refused += other.refused;
            hits += other.hits;
            lights += other.lights;
            rays += other.rays;
        }
    };

    // How many light samples and gather rays share the camera's hit x1, which is the costly part of a sample.
    struct Splitting {
        int lights = 1, rays = 1;
        // Indices of the first ones in the pixel's sequences of random numbers, and the stream of these.
        uint32_t firstLight = 0, firstRay = 0;
        uint64_t stream = 0;
        // By which the probability that a path trains is multiplied: less where a pixel has more camera samples.
        float training = 1;
        // Otherwise the path just goes on.
        bool splits() const { return lights > 1 || rays > 1; }
    };
    // Estimates of the variance of one light sample's and one ray's luminance, from those that share a hit; negative
    // where there was but one, or no such hit. Because N samples that share a hit are stratified, the estimates are too
    // large, by up to N / (N - 1).
    struct Noise {
        float lights = -1, rays = -1;
    };
    // What a sample reads and what it adds to.
    struct Sample {
        Sampler& sampler;  // continues with the specular chain
        const RadianceCache& cache;
        Splitting splitting;
        uint64_t seed;                        // of the random numbers for look-ups
        std::vector<CacheDeposit>& deposits;  // are appended
        Counts& counts;
        GBufferSample* gBuffer = nullptr;  // may be null
        Noise noise{};                     // is set
    };

    // Both must outlive this object.
    FinalGather(const DirectLighting& lighting, const PathSettings& settings)
        : lighting_(lighting), walker_(lighting, settings) {}

    // All light that arrives at the ray's origin along it. A path trains the cache, that is it goes on and makes
    // deposits, with the probability that the cache asks for, times `training`, divided by the number of rays that
    // share the hit: a deposit then counts in the cells as its look-up counts in the picture.
    Rgb radiance(const Ray& ray, Sample& sample) const;

  private:
    struct Branch;
    Rgb follow(PathState path, Sampler& sampler, Sample& sample, Pcg32& random, const Branch& branch) const;
    Rgb split(const PathState& path, const SurfaceInteraction& hit, const Bsdf& bsdf, Sample& sample,
              Pcg32& random) const;

    const DirectLighting& lighting_;
    PathWalker walker_;
};

}  // namespace drc
