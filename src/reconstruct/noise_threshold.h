// Decides when the error of the denoised picture is estimated during a render, and when it is small enough to stop.
#pragma once
#include <optional>

namespace drc {

class NoiseThreshold {
  public:
    // Samples per pixel at the first estimate: with fewer, the halves have too few for any estimate.
    static constexpr int kFirst = 8;

    // threshold: for DenoisedError::whole; 0: no threshold.
    explicit NoiseThreshold(double threshold);

    // Whether the error should be estimated now. samples: taken of each pixel so far. An estimate takes time.
    bool isDue(int samples) const;
    // Records an estimate. error: with this many samples per pixel. samples must increase from call to call.
    void estimated(int samples, double error);
    // The latest estimate.
    std::optional<double> error() const { return error_; }
    bool reached() const { return error_ && *error_ <= threshold_; }
    // The estimated exponent of the error's decrease: error ~ samples^-slope.
    double slope() const { return slope_; }
    // The estimated number of samples per pixel that reaches the threshold; none before the first estimate.
    std::optional<double> samplesNeeded() const;

  private:
    double threshold_;
    int samples_ = 0;  // at the latest estimate
    std::optional<double> error_;
    double slope_;
};

}  // namespace drc
