// All metrics of a picture against two independent references of one scene.
#pragma once
#include <array>
#include <string>

#include "image/cross_error.h"
#include "image/image.h"

namespace drc {

// SSIM or FLIP counts as noisy if the noise of the references' mean exceeds this share of 1 - SSIM or of FLIP.
inline constexpr double kMostDisplayedNoise = 0.25;

struct PairMetrics {
    CrossErrors errors;
    double ssim = 0, flip = 0;  // ssim.h and flip.h, against the mean of both references
    // Whether the noise of this mean (ReferencePair::ssimNoise, flipNoise) exceeds kMostDisplayedNoise of the metric.
    bool ssimIsNoisy = false, flipIsNoisy = false;
    std::array<double, 2> pngKb{};  // as in metrics.h; the first is of the references' mean
};

// Two references, with the data that all comparisons with them share.
class ReferencePair {
  public:
    // first, second: linear RGB, rendered with different seeds. The names are for messages. exposure: as in metrics.h.
    // Throws Error if the sizes differ, or if both are the same picture, whose noise would count as the test image's
    // error.
    ReferencePair(Image first, Image second, float exposure = 0, const std::string& firstName = "the first reference",
                  const std::string& secondName = "the second reference");

    const Image& first() const { return first_; }
    const Image& second() const { return second_; }
    const Image& mean() const { return mean_; }
    const Image& norm() const { return norm_; }  // relative_norm.h

    // Approximately the 1 - SSIM and the FLIP of a perfect picture against the mean, which are due to the noise of the
    // mean. The difference of the references has four times the variance of their mean; SSIM's loss is proportional to
    // the variance, FLIP to the standard deviation.
    double ssimNoise() const { return ssimNoise_; }
    double flipNoise() const { return flipNoise_; }

    // Throws Error if the sizes differ, and if the test image is one of the references.
    PairMetrics compare(const Image& test, const std::string& testName = "the test image") const;

  private:
    Image first_, second_, mean_, norm_;
    Image shown_;  // the mean with the exposure applied
    float exposure_ = 0;
    std::string firstName_, secondName_;
    double ssimNoise_ = 0, flipNoise_ = 0, pngKb_ = 0;
};

}  // namespace drc
