// Averages pixels along the surfaces that they show: neighbours are weighted by a cubic B-spline and by whether they
// lie on the same surface (the edge-avoiding a-trous filter of Dammertz et al., "Edge-Avoiding A-Trous Wavelet
// Transform for fast Global Illumination Filtering", 2010).
#pragma once
#include <optional>
#include <vector>

#include "math/vec.h"

namespace drc {

// Single-channel images of one size, row-major, initially zero.
class Planes {
  public:
    Planes(size_t pixels, int count)
        : stride_(strideOf(pixels)), values_(stride_ * size_t(count), 0.f), count_(count) {}
    int count() const { return count_; }
    float* plane(int c) { return values_.data() + size_t(c) * stride_; }
    const float* plane(int c) const { return values_.data() + size_t(c) * stride_; }

  private:
    // At each pixel, all planes are read together. At most common image sizes, planes would be a multiple of 4096 bytes
    // apart, and their lines would compete for the same eight ways of the first-level cache; the offset prevents that.
    static size_t strideOf(size_t pixels) {
        constexpr size_t kPage = 4096 / sizeof(float), kApart = 5 * 64 / sizeof(float);
        return (pixels + kPage - 1) / kPage * kPage + kApart;
    }

    size_t stride_;
    std::vector<float> values_;
    int count_;
};

class SurfaceFilter {
  public:
    // Initially no pixel shows a surface.
    SurfaceFilter(int width, int height);

    // Sets what pixel i shows: a point, its unit normal, and the width of a pixel there, in world units. With a size of
    // zero, or values that are not finite, it shows no surface to average along.
    void show(size_t i, const Vec3& p, const Vec3& n, float size);
    bool covers(size_t i) const { return perSize_[i] > 0; }
    // From now on, neighbours are also weighted by the similarity of their values, by exp(-d / (noise of one + noise of
    // the other)), where d is the squared difference, summed over the planes. noise: one plane of variances, 0 or more.
    void guideBy(Planes values, Planes noise);

    // out: the means of each plane over the 5x5 neighbours at steps of `dilation` pixels; zero where no surface is
    // shown.
    void average(int dilation, const Planes& in, Planes& out) const;
    // The sum of the weights of each pixel's neighbours, including its own weight of 9/64; at most one.
    std::vector<float> weights(int dilation) const;

  private:
    struct Neighbours;
    struct Weights;
    template <typename F>
    void forEachWeighed(int dilation, const F& f) const;
    void weigh(size_t row, int x, const Neighbours& neighbours, Weights& result) const;
    void weighValues(size_t row, int x, Weights& weights) const;

    int width_, height_;
    Planes point_, normal_;
    std::vector<float> perSize_;  // 1 / size; 0: no surface
    std::optional<Planes> guide_, noise_;
};

}  // namespace drc
