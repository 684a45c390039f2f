// Sums of samples per pixel, in layers.
#pragma once
#include <vector>

#include "image/image.h"
#include "scene/scene.h"

namespace drc {

// What a sum of values times filter weights is divided by, for a mean: the sum of the weights. A filter with negative
// lobes may sum to nearly nothing over few samples; its expected sum is then the better divisor.
template <typename T>
T filterDivisor(T weights, T expected) {
    return weights > T(0.25) * expected ? weights : expected;
}

// One layer over a region of the film. Different pixels may be added to from different threads.
class FilmLayer {
  public:
    FilmLayer() = default;
    explicit FilmLayer(const PixelRegion& region) : region_(region), pixels_(region.count()) {}

    // value: radiance; filterWeight: of the pixel filter, 1 on average.
    void add(int x, int y, const Rgb& value, float filterWeight);
    // Radiance; black if nothing was added.
    Rgb value(int x, int y) const;
    // Region-sized.
    Image image(float scale) const;
    const PixelRegion& region() const { return region_; }

  private:
    struct Pixel {
        double sum[3] = {0, 0, 0};
        double weight = 0;  // sum of filter weights
        double count = 0;
    };
    PixelRegion region_{};
    std::vector<Pixel> pixels_;
};

}  // namespace drc
