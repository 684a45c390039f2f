// Decides when the error of the denoised picture is estimated during a render, and when it is small enough to stop.
#pragma once
#include <optional>

namespace drc {

class NoiseThreshold {
  public:
    // Samples a pixel before the first estimate: with less, the halves have too few to tell anything.
    static constexpr int kFirst = 8;

    // threshold: of DenoisedError::whole; 0: it is never small enough.
    explicit NoiseThreshold(double threshold);

    // Whether the error should be estimated, which takes time, now that each pixel has so many samples.
    bool isDue(int samples) const;
    // error: after so many samples. Counts must increase from call to call.
    void estimated(int samples, double error);
    // The latest estimate.
    std::optional<double> error() const { return error_; }
    bool reached() const { return error_ && *error_ <= threshold_; }
    // The exponent by which the error falls, as far as can be told: error ~ samples^-slope.
    double slope() const { return slope_; }
    // The number of samples a pixel at which the threshold will be reached, as far as can be told.
    std::optional<double> samplesNeeded() const;

  private:
    double threshold_;
    int samples_ = 0;  // at the latest estimate
    std::optional<double> error_;
    double slope_;
};

}  // namespace drc
