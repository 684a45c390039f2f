// Adaptive sampling: decides how many camera samples each part of a picture gets, from the error that a denoiser would
// leave there.
//
// A denoiser averages over pixels that look alike. Noise remains where few pixels do: at edges and in fine detail. This
// is estimated in cells of a few pixels. A cell's noise is the difference between the means of two halves of its camera
// samples, as in Rousselle et al., "Adaptive Rendering with Non-Local Means Filtering" (2012). The estimate is the
// noise that remains after a small bilateral filter guided by albedo and normal. It has more weight where the picture
// has contrast, because there a real denoiser averages over fewer pixels than this filter does.
//
// A block's number of samples depends on all samples of its pixels together, so that it hardly depends on those of any
// single pixel, and does not make the picture darker or brighter (Kirk & Arvo, "Unbiased Sampling Techniques for Image
// Synthesis", 1991).
#pragma once
#include <vector>

#include "base/state_file.h"
#include "image/image.h"
#include "transport/g_buffer_sample.h"

namespace drc {

class SampleDensity {
  public:
    static constexpr int kCell = 4, kBlock = 16;  // edge lengths, in pixels
    // Bounds of a block's density.
    static constexpr double kLeast = 0.5, kMost = 8;

    // displayScale: factor on radiance for display.
    SampleDensity(const PixelRegion& region, float displayScale);

    // Records a camera sample. half: 0 or 1, the half of the samples that it belongs to. value: its luminance. Threads
    // may add to different rows at the same time.
    void add(int x, int y, int half, float value, const GBufferSample& surface);
    // Recomputes the densities from all samples so far, if their number has grown enough since the last time. samples:
    // the mean number of samples per pixel.
    void update(int samples);

    // Number of blocks in a row, and the index of a pixel's block.
    int columns() const { return (region_.width() + kBlock - 1) / kBlock; }
    size_t blockOf(int x, int y) const {
        return size_t((y - region_.y0) / kBlock) * size_t(columns()) + size_t((x - region_.x0) / kBlock);
    }
    size_t blocks() const { return densities_.size(); }
    // Ratio of the number of camera samples of the block's pixels to the number with uniform sampling. Its mean over
    // all pixels is 1.
    double density(size_t block) const { return densities_[block]; }

    void save(StateWriter& to) const;
    // Reads what save() wrote into an object that was made with the same arguments.
    void load(StateReader& from);

  private:
    // Sums over a cell, or over the part of a cell that lies in one row of pixels.
    struct Sums {
        float value[2] = {0, 0}, samples[2] = {0, 0};
        Rgb albedo{0.f};
        Vec3 normal{0.f};
        void add(const Sums& other);
        float count() const { return samples[0] + samples[1]; }
    };
    // A cell's contribution to the mean noise and contrast of its block.
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
    std::vector<Sums> rows_;  // sums since the last addRows(), by row of pixels and column of cells
    std::vector<double> densities_;
    int nextUpdate_ = 1;  // number of samples at which update() next recomputes
};

}  // namespace drc
