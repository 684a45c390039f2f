// All metrics of a picture against two independent references of one scene.
#pragma once
#include <array>
#include <string>

#include "image/cross_error.h"
#include "image/image.h"

namespace drc {

// The largest share of a metric of displayed colours that the noise of the references' mean may have.
inline constexpr double kMostDisplayedNoise = 0.25;

struct PairMetrics {
    CrossErrors errors;
    double ssim = 0, flip = 0;  // ssim.h and flip.h, against the mean of both references
    // Whether the noise of this mean is more than a quarter of the metric (ReferencePair::ssimNoise, flipNoise).
    bool ssimIsNoisy = false, flipIsNoisy = false;
    std::array<double, 2> pngKb{};  // as in metrics.h; the first is of the references' mean
};

// Two references, with what all comparisons with them share.
class ReferencePair {
  public:
    // Linear RGB, of different seeds; names for messages. exposure: as in metrics.h. Throws Error if the sizes differ,
    // and if both are the same picture, whose noise would count as the test image's error.
    ReferencePair(Image first, Image second, float exposure = 0, const std::string& firstName = "the first reference",
                  const std::string& secondName = "the second reference");

    const Image& first() const { return first_; }
    const Image& second() const { return second_; }
    const Image& mean() const { return mean_; }
    const Image& norm() const { return norm_; }  // relative_norm.h

    // Approximately how far a perfect picture is from SSIM 1 and FLIP 0, because of the noise of the mean. The
    // difference of the references has four times the variance of their mean; SSIM's loss is proportional to the
    // variance, FLIP to the standard deviation.
    double ssimNoise() const { return ssimNoise_; }
    double flipNoise() const { return flipNoise_; }

    // Throws Error if the sizes differ, and if the test image is one of the references.
    PairMetrics compare(const Image& test, const std::string& testName = "the test image") const;

  private:
    Image first_, second_, mean_, norm_;
    Image shown_;  // the mean, as it is displayed
    float exposure_ = 0;
    std::string firstName_, secondName_;
    double ssimNoise_ = 0, flipNoise_ = 0, pngKb_ = 0;
};

}  // namespace drc
