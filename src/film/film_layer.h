// One layer of a film: for each pixel the sum of sample values times their filter weights, in one or several
// independent groups of samples. The differences between the groups give the variance of the mean.
//
// Exact layers store sums as integers, in units of a quantum, so that the result does not depend on the order of
// additions: renders agree to the bit for any number of threads, split into shards, or resumed. Sums saturate at 2^63
// quanta. Layers in single precision need half the memory.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "scene/scene.h"

namespace drc {

struct FilmLayerSpec {
    std::string name;
    int channels = 3;
    int groups = 1;        // 2: half buffers
    bool weighted = true;  // also stores the sum of the weights, which means need; false: sums of values only
    enum class Storage { Exact, Single } storage = Storage::Exact;
    double quantum = 0x1p-24;  // unit of the sums of exact layers; a power of two
    bool operator==(const FilmLayerSpec&) const = default;
    // Memory per pixel.
    size_t bytesPerPixel() const;
};

// The quantum for radiance in a film whose values are multiplied by `scale` for display. In display units, the quantum
// is 6e-8 and sums may reach 5e11.
double radianceQuantum(float scale);

// The divisor that turns a sum of values times filter weights into a mean: normally the sum of the weights. Filters
// with negative lobes keep that sum away from zero for the first samples of a pixel (Filter::sample), but it may be
// nearly zero for a random half of them, or for a shard that starts at a later sample. Then the expectation of the sum
// is the better divisor.
template <typename T>
T filterDivisor(T weights, T expected) {
    return std::abs(weights) > T(0.25) * expected ? weights : expected;
}

class FilmLayer {
  public:
    FilmLayer() = default;
    FilmLayer(const PixelRegion& region, const FilmLayerSpec& spec);

    // Adds a sample. weight: weight of the pixel filter, 1 on average. importance: weight of the sample's pass relative
    // to other passes, positive; exact layers ignore it. Threads may add to different pixels at the same time.
    void add(int x, int y, int group, std::span<const float> values, float weight, float importance = 1);
    void add(int x, int y, int group, const Rgb& value, float weight, float importance = 1) {
        const float values[] = {value.x, value.y, value.z};
        add(x, y, group, values, weight, importance);
    }
    // Adds to any pixel, from any thread. Only for exact layers without weights.
    void splat(int x, int y, const Rgb& value);

    // Whether a group has samples; the number of groups that have samples; whether all groups have samples.
    bool has(int x, int y, int group) const { return expected(x, y, group) > 0; }
    int groupsWithSamples(int x, int y) const;
    bool complete(int x, int y) const { return groupsWithSamples(x, y) == spec_.groups; }
    // The expected sum of the weights, over all groups or for one group: the number of samples in exact layers, the sum
    // of their importances in other layers.
    double expected(int x, int y) const;
    double expected(int x, int y, int group) const;
    // The sum of a channel over all groups, or in one group.
    double sum(int x, int y, int channel) const;
    double sum(int x, int y, int channel, int group) const { return value(x, y, group, size_t(channel)); }
    // The weighted mean of the first three channels, in one group or over all groups; black without samples.
    Rgb group(int x, int y, int group) const;
    Rgb mean(int x, int y) const;
    // The variance of the mean, from the differences between groups; zero if fewer than two groups have samples. Errors
    // that all groups share, such as those of a pass's radiance maps, are not included.
    Rgb varianceOfMean(int x, int y) const;
    // The means times a scale, as an image of the region's size.
    Image image(float scale = 1) const;

    // Adds the other layer's sums, as if all its samples had been taken for this layer. Both layers must have the same
    // region and spec.
    void add(const FilmLayer& other);
    // The memory of a row, as bytes.
    std::span<std::byte> row(int y);
    std::span<const std::byte> row(int y) const;
    // Copies a row from a layer with the same spec, whose region must contain this layer's region.
    void copyRow(const FilmLayer& from, int y);

    const PixelRegion& region() const { return region_; }
    const FilmLayerSpec& spec() const { return spec_; }

  private:
    size_t recordSize() const { return size_t(spec_.channels) + (spec_.weighted ? 2 : 0); }
    size_t record(int x, int y, int group) const {
        return (region_.index(x, y) * size_t(spec_.groups) + size_t(group)) * recordSize();
    }
    // Quanta per unit: 1 / quantum.
    double perQuantum_ = 1;
    bool exact() const { return spec_.storage == FilmLayerSpec::Storage::Exact; }
    // Entry `i` of a group's record: the channels, then the sum of the weights, then the sum of the importances.
    double value(int x, int y, int group, size_t i) const;

    PixelRegion region_{};
    FilmLayerSpec spec_;
    std::vector<int64_t> exact_;  // exact_ or single_ is empty, depending on the storage
    std::vector<float> single_;
};

}  // namespace drc
