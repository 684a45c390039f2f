// Turns the density of camera samples (SampleDensity) into what final gather takes in each pass: how many samples of
// each pixel, and how often their paths train the radiance cache.
#pragma once
#include <vector>

#include "base/state_file.h"
#include "film/sample_pass.h"
#include "integrators/sample_density.h"

namespace drc {

class SamplePlanner {
  public:
    // Camera samples of a pixel for each that it would have if all had the same number.
    static constexpr int kMostSamples = int(SampleDensity::kMost);

    // displayScale: by which radiance is multiplied for display. firstSample: index of the picture's first camera
    // sample.
    SamplePlanner(const PixelRegion& region, float displayScale, uint32_t firstSample);

    // The camera samples of a pixel in the present pass.
    PixelSamples samples(int x, int y) const { return parts_[density_.blockOf(x, y)].samples; }
    // Training probability is divided by sample density, so that each pixel deposits equally in the cells, just as it
    // counts equally in the picture. Returns the factor, 1 / density.
    float training(int x, int y) const { return parts_[density_.blockOf(x, y)].training; }

    // As SampleDensity::add().
    void add(int x, int y, int half, float value, const GBufferSample& surface) {
        density_.add(x, y, half, value, surface);
    }
    // Plans the next pass, when each pixel has so many samples in the mean. wholeSample: the latest pass was the last
    // one of a sample.
    void update(int samples, bool wholeSample);

    void save(StateWriter& to) const;
    // Reads what save() wrote into an object that was made with the same arguments.
    void load(StateReader& from);

  private:
    // A block of SampleDensity.
    struct Part {
        PixelSamples samples;
        double wanted = 1;  // camera samples of a pixel, up to and including the present pass
        float training = 1;
    };

    SampleDensity density_;
    std::vector<Part> parts_;
};

}  // namespace drc
