// Turns the density of camera samples (SampleDensity) into the plan of final gather for each pass: how many samples
// each pixel gets, and how often their paths train the radiance cache.
#pragma once
#include <vector>

#include "base/state_file.h"
#include "film/sample_pass.h"
#include "integrators/sample_density.h"

namespace drc {

class SamplePlanner {
  public:
    // Greatest number of a pixel's camera samples per sample with uniform sampling.
    static constexpr int kMostSamples = int(SampleDensity::kMost);

    // displayScale: factor on radiance for display. firstSample: index of the picture's first camera sample.
    SamplePlanner(const PixelRegion& region, float displayScale, uint32_t firstSample);

    // The camera samples of a pixel in the current pass.
    PixelSamples samples(int x, int y) const { return parts_[density_.blockOf(x, y)].samples; }
    // Factor on the training probability: 1 / density, so that each pixel deposits equally in the cells, just as it
    // counts equally in the picture.
    float training(int x, int y) const { return parts_[density_.blockOf(x, y)].training; }

    // As SampleDensity::add().
    void add(int x, int y, int half, float value, const GBufferSample& surface) {
        density_.add(x, y, half, value, surface);
    }
    // Plans the next pass. samples: the mean number of samples per pixel so far. wholeSample: the latest pass completed
    // a sample of every pixel.
    void update(int samples, bool wholeSample);

    void save(StateWriter& to) const;
    // Reads what save() wrote into an object that was made with the same arguments.
    void load(StateReader& from);

  private:
    // A block of SampleDensity.
    struct Part {
        PixelSamples samples;
        double wanted = 1;  // camera samples of a pixel up to and including the current pass, not rounded
        float training = 1;
    };

    SampleDensity density_;
    std::vector<Part> parts_;
};

}  // namespace drc
