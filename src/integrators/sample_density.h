// Adaptive sampling: decides how many camera samples parts of a picture get, by the error that a denoiser would leave
// there.
//
// A denoiser averages over pixels that look alike. What it leaves is where there are few of them: noise at edges and in
// fine detail. This is estimated in cells of a few pixels, whose noise shows as the difference between the means of two
// halves of their camera samples, as in Rousselle et al., "Adaptive Rendering with Non-Local Means Filtering" (2012).
// Counted is the noise that a small bilateral filter leaves which is guided by albedo and normal. It counts more where
// the picture has contrast, because there a real denoiser averages over less than this filter does.
//
// A block's number of samples follows from all samples of its pixels together, so that it hardly depends on any one
// pixel's, and does not make the picture darker or brighter (Kirk & Arvo, "Unbiased Sampling Techniques for Image
// Synthesis", 1991).
#pragma once
#include <vector>

#include "base/state_file.h"
#include "image/image.h"
#include "transport/g_buffer_sample.h"

namespace drc {

class SampleDensity {
  public:
    static constexpr int kCell = 4, kBlock = 16;  // pixels
    // Bounds of a block's density.
    static constexpr double kLeast = 0.5, kMost = 8;

    // displayScale: by which radiance is multiplied for display.
    SampleDensity(const PixelRegion& region, float displayScale);

    // Records a camera sample. half: 0 or 1, the one of the two pictures that it belongs to. value: luminance.
    // Different rows may be added to from different threads.
    void add(int x, int y, int half, float value, const GBufferSample& surface);
    // Decides anew, from all samples so far, if there are so many more than at the last time that this pays. samples:
    // those that each pixel has had in the mean.
    void update(int samples);

    // Blocks in a row, and the index of a pixel's block.
    int columns() const { return (region_.width() + kBlock - 1) / kBlock; }
    size_t blockOf(int x, int y) const {
        return size_t((y - region_.y0) / kBlock) * size_t(columns()) + size_t((x - region_.x0) / kBlock);
    }
    size_t blocks() const { return densities_.size(); }
    // The camera samples of a block's pixels, for each that they would have if all pixels had the same number. The mean
    // over all pixels is 1.
    double density(size_t block) const { return densities_[block]; }

    void save(StateWriter& to) const;
    // Reads what save() wrote into an object that was made with the same arguments.
    void load(StateReader& from);

  private:
    // Sums over a cell, or over a row of its pixels.
    struct Sums {
        float value[2] = {0, 0}, samples[2] = {0, 0};
        Rgb albedo{0.f};
        Vec3 normal{0.f};
        void add(const Sums& other);
        float count() const { return samples[0] + samples[1]; }
    };
    // A cell's contribution to the means of its block.
    struct Estimate {
        double noise = 0, contrast = 0;
    };
    int cellColumns() const { return (region_.width() + kCell - 1) / kCell; }
    int cellRows() const { return (region_.height() + kCell - 1) / kCell; }
    void addRows();
    std::vector<Estimate> estimates() const;
    void decide(const std::vector<double>& errors);

    PixelRegion region_;
    float scale_;
    std::vector<Sums> cells_;
    std::vector<Sums> rows_;  // since the last addRows(): by row of pixels, and column of cells
    std::vector<double> densities_;
    int nextUpdate_ = 1;  // samples
};

}  // namespace drc
