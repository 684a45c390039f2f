// How noisy each pixel is: variance over its samples, gathered while they come.
#pragma once
#include <vector>

#include "image/image.h"
#include "scene/scene.h"

namespace drc {

class FilmVariance {
  public:
    FilmVariance() = default;
    explicit FilmVariance(const PixelRegion& region) : region_(region), pixels_(region.count()) {}

    // value: radiance of a sample times its filter weight. Different pixels may be added to from different threads.
    void add(int x, int y, const Rgb& value);

    int count(int x, int y) const { return pixels_[region_.index(x, y)].count; }
    // Of the mean of the samples, as if they were independent: of well distributed ones it is the more too large the
    // smoother what they integrate is. Zero below two samples.
    Rgb ofMean(int x, int y) const;

    const PixelRegion& region() const { return region_; }

  private:
    // Welford, "Note on a Method for Calculating Corrected Sums of Squares and Products", 1962.
    struct Pixel {
        int count = 0;
        float mean[3] = {0, 0, 0};
        float squares[3] = {0, 0, 0};  // of the differences from the mean
    };
    PixelRegion region_{};
    std::vector<Pixel> pixels_;
};

}  // namespace drc
