// Decides, for blocks of pixels and from what earlier samples have found there, how many camera samples final gather
// takes in a pass (SampleDensity), and how many light samples and gather rays share the hit of each.
//
// Rays: a camera sample of cost c and variance v, of which n rays of cost r add a variance of w / n, has the least
// product of cost and variance with n = sqrt(w c / (v r)): splitting as of Arvo & Kirk, "Particle Transport and Image
// Synthesis" (1990). v and c are those of the whole picture; w is the block's. Variances are relative to the squared
// radiance of the block, as the eye sees them.
#pragma once
#include <algorithm>
#include <vector>

#include "base/state_file.h"
#include "integrators/final_gather.h"
#include "render/sample_density.h"
#include "render/sample_pass.h"
#include "scene/scene.h"

namespace drc {

class SamplePlanner {
  public:
    static constexpr int kBlock = 32;  // pixels
    static constexpr int kMostRays = 16, kMostLights = 8;
    // Camera samples of a pixel for each that it would have if all had the same number.
    static constexpr int kMostSamples = int(SampleDensity::kMost);

    // displayScale: by which radiance is multiplied for display. firstSample: index of the picture's first camera
    // sample.
    SamplePlanner(const PixelRegion& region, float displayScale, uint32_t firstSample);

    // The camera samples of a pixel in the present pass, and for each of them, which has this index within the pixel,
    // how it is split.
    PixelSamples samples(int x, int y) const { return parts_[density_.blockOf(x, y)].samples; }
    FinalGather::Splitting splitting(int x, int y, uint32_t index) const;
    // Whether a pixel is one of those, a quarter of all, that noise is measured in: they always have two light samples
    // and rays or more, and add() wants their mean.
    static bool measures(int x, int y) { return ((x + 2 * y) & 3) == 0; }

    // A camera sample that was taken as samples() and splitting() say.
    struct Taken {
        float value = 0;  // luminance
        FinalGather::Noise noise = {};
        int half = 0;  // 0 or 1, the one of the two pictures for SampleDensity that it belongs to
        GBufferSample surface = {};
        // The mean luminance of the pixel's earlier samples and their number, if measures().
        float mean = 0;
        double samples = 0;
    };
    // Different rows may be added to from different threads.
    void add(int x, int y, const Taken& sample);
    // Plans the next samples, when each pixel has so many. wholeSample: the latest pass was the last one of a sample.
    void update(int samples, bool wholeSample);

    void save(StateWriter& to) const;
    // Reads what save() wrote into an object that was made with the same arguments.
    void load(StateReader& from);

  private:
    struct Sums {
        double lights = 0, rays = 0;        // variances
        double lightHits = 0, rayHits = 0;  // how many
        double value = 0, values = 0;
        // Of a sample's difference from the pixel's mean, and the part of it that more light samples and rays would
        // lessen.
        double square = 0, split = 0, squares = 0;
        void add(const Sums& other);
        void save(StateWriter& to) const;
        void load(StateReader& from);
    };
    struct Block {
        Sums sums;
        int lights = 1, rays = 1;
        // More where pixels measure.
        int lightsAt(bool measures) const { return measures ? std::max(lights, 2) : lights; }
        int raysAt(bool measures) const { return measures ? std::max(rays, 2) : rays; }
    };
    // A block of SampleDensity.
    struct Part {
        PixelSamples samples;
        double wanted = 1;  // camera samples of a pixel, up to and including the present pass
        // In the sequences of pixels that do not measure and of those that do.
        uint32_t firstLight[2] = {0, 0}, firstRay[2] = {0, 0};
        float training = 1;  // FinalGather::Splitting::training
    };
    static_assert(kBlock % SampleDensity::kBlock == 0, "a part lies within one block");
    void planSamples();
    double relative(const Block& block, double variance) const;
    int columns() const { return (region_.width() + kBlock - 1) / kBlock; }
    size_t blockOf(int x, int y) const {
        return size_t((y - region_.y0) / kBlock) * size_t(columns()) + size_t((x - region_.x0) / kBlock);
    }
    const Block& blockOfPart(size_t part) const;

    PixelRegion region_;
    float scale_;
    SampleDensity density_;
    std::vector<Block> blocks_;
    std::vector<Part> parts_;
    std::vector<Sums> rows_;  // of the present pass, by row and column of blocks
};

}  // namespace drc
