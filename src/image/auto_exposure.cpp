#include "image/auto_exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "image/view_transform.h"

namespace drc {
namespace {

// The histogram of log2 luminance: all positive floats, in bins of a 32nd of a stop.
constexpr int kBinsPerStop = 32;
constexpr int kLowest = -126, kHighest = 128;

// The brightest tenth may be clipped.
constexpr double kMayClip = 0.1;
// The luminance at which the brightest tenth should begin, and the most stops by which the picture is brightened for
// this.
constexpr double kBrightBegins = 0.7, kMostLift = 1;
// Pixels darker than the brightest tenth by more stops than this are black in any view: borders, dark rooms behind open
// doors.
constexpr int kBlackStops = 10;
// Share of the remaining pixels that the trimmed mean drops at each end.
constexpr double kTrimmed = 0.1;

class LogHistogram {
  public:
    void add(float luminance) {
        const float bin = (std::log2(luminance) - kLowest) * kBinsPerStop;
        ++counts_[size_t(std::clamp(int(bin), 0, int(counts_.size()) - 1))];
    }
    int64_t countFrom(int first) const {
        int64_t count = 0;
        for (size_t i = size_t(std::max(first, 0)); i < counts_.size(); ++i) count += counts_[i];
        return count;
    }
    // The lowest bin such that at most the share `share` of the pixels in bin `first` and above lie above it.
    int quantileFromTop(int first, double share) const {
        const double most = share * double(countFrom(first));
        int64_t above = 0;
        int bin = int(counts_.size()) - 1;
        while (bin > first && double(above + counts_[size_t(bin)]) <= most) above += counts_[size_t(bin--)];
        return bin;
    }
    // Mean log2 luminance of the pixels in bin `first` and above, without the given share at either end. A partly
    // trimmed bin counts in part.
    double trimmedMean(int first, double share) const {
        const double total = double(countFrom(first)), low = share * total, high = (1 - share) * total;
        double sum = 0, weight = 0, below = 0;
        for (size_t i = size_t(std::max(first, 0)); i < counts_.size(); ++i) {
            const double count = double(counts_[i]);
            const double kept = std::max(0.0, std::min(high, below + count) - std::max(low, below));
            sum += kept * stops(int(i));
            weight += kept;
            below += count;
        }
        return sum / weight;
    }
    // log2 luminance in the middle of a bin.
    static double stops(int bin) { return kLowest + (bin + 0.5) / kBinsPerStop; }

  private:
    std::array<int64_t, size_t((kHighest - kLowest) * kBinsPerStop)> counts_{};
};

}  // namespace

float autoExposure(const Image& linear) {
    LogHistogram histogram;
    for (int y = 0; y < linear.height(); ++y)
        for (int x = 0; x < linear.width(); ++x)
            if (const float l = luminance(linear.rgb(x, y)); l > 0 && std::isfinite(l)) histogram.add(l);
    if (histogram.countFrom(0) == 0) return 0;
    const int brightest = histogram.quantileFromTop(0, kMayClip);
    const int notBlack = std::max(0, brightest - kBlackStops * kBinsPerStop);
    const double forTheMean = std::log2(double(kMiddleGrey)) - histogram.trimmedMean(notBlack, kTrimmed);
    const double forTheBright = -LogHistogram::stops(histogram.quantileFromTop(notBlack, kMayClip));
    const double stops = std::min(forTheMean, forTheBright);
    const double lift = forTheBright + std::log2(kBrightBegins) - stops;
    return float(stops + std::clamp(lift, 0.0, kMostLift));
}

}  // namespace drc
