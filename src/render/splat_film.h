// Light that lands anywhere on the film, not in the pixel that asked for it: what paths from the lights bring to the
// lens. Each splat counts for all pixels whose filter reaches it.
#pragma once
#include <span>
#include <vector>

#include "integrators/bdpt.h"

namespace drc {

class SplatFilm {
  public:
    // The filter must outlive the film.
    SplatFilm(const PixelRegion& region, const Filter& filter);
    // What some light paths brought.
    struct Catch {
        uint64_t paths = 0;
        std::vector<Splat> splats;
    };
    // On all cores, and for each pixel in the order given: the same sums every time.
    void add(std::span<const Catch> catches);
    // Radiance: the mean of a sweep that has as many light paths as the region has pixels. Black before the first path.
    Rgb value(int x, int y) const;

  private:
    PixelRegion region_{};
    const Filter* filter_ = nullptr;
    float scale_ = 0;  // makes the filter's integral 1
    std::vector<double> sums_;
    uint64_t paths_ = 0;
};

}  // namespace drc
