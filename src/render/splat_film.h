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
    // On all cores, and for each pixel in the order given: the same sums every time. Takes time in proportion to the
    // splats and what the filter covers, whatever the film's height.
    void add(std::span<const Catch> catches);
    // Radiance: the mean of a sample pass that has as many light paths as the region has pixels. Black before the first
    // path.
    Rgb value(int x, int y) const;
    // How often a splat was looked at: once for each band of rows that it reaches.
    uint64_t visits() const { return visits_; }

  private:
    static constexpr int kRows = 16;  // of a band, which is one thread's
    struct Reach {
        Vec2 at{0, 0};  // the splat, where pixels' centres are whole numbers
        int x0 = 0, x1 = -1, y0 = 0, y1 = -1;
    };
    struct Bands {
        std::vector<size_t> begin;         // of each band in splats; one more at the end
        std::vector<const Splat*> splats;  // of one band after the other
    };
    Reach reach(const Splat& splat) const;
    Bands sortIntoBands(std::span<const Catch> catches) const;

    PixelRegion region_{};
    const Filter* filter_ = nullptr;
    float scale_ = 0;  // makes the filter's integral 1
    std::vector<double> sums_;
    uint64_t paths_ = 0, visits_ = 0;
};

}  // namespace drc
