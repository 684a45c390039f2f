// One layer of a film: for each pixel the sum of sample values times their filter weights, in one or several
// independent groups. The differences between groups give the variance of their mean.
//
// Exact layers keep sums as integers, in units of a quantum, so that the order of additions does not change a bit: any
// number of threads, shards and resumed renders agree. Sums saturate at 2^63 quanta. Layers in single precision take
// half the memory.
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
    bool weighted = true;  // also keeps the sum of weights, for means; false: sums of values alone
    enum class Storage { Exact, Single } storage = Storage::Exact;
    double quantum = 0x1p-24;  // of exact layers; a power of two
    bool operator==(const FilmLayerSpec&) const = default;
    // Memory for one pixel.
    size_t bytesPerPixel() const;
};

// The quantum for radiance in a film that is multiplied by `scale` for display: displayed values sum up to 5e11, in
// steps of 6e-8.
double radianceQuantum(float scale);

// The divisor that turns a sum of values times filter weights into a mean: the sum of the weights. The weights of a
// pixel's first samples never sum to nearly zero (Filter::sample), but those of a random half of them may, and those of
// a shard that does not begin with the first sample; the sum's expectation is then the better divisor.
template <typename T>
T filterDivisor(T weights, T expected) {
    return std::abs(weights) > T(0.25) * expected ? weights : expected;
}

class FilmLayer {
  public:
    FilmLayer() = default;
    FilmLayer(const PixelRegion& region, const FilmLayerSpec& spec);

    // Adds a sample. weight: of the pixel filter, 1 on average. importance: common to all samples of a pass, any
    // positive number; 1 in exact layers. Different pixels may be added to from different threads.
    void add(int x, int y, int group, std::span<const float> values, float weight, float importance = 1);
    void add(int x, int y, int group, const Rgb& value, float weight, float importance = 1) {
        const float values[] = {value.x, value.y, value.z};
        add(x, y, group, values, weight, importance);
    }
    // Adds to any pixel, from any thread. For exact layers without weights.
    void splat(int x, int y, const Rgb& value);

    // Whether a group has a sample; how many groups do; whether all of them do.
    bool has(int x, int y, int group) const { return expected(x, y, group) > 0; }
    int groupsWithSamples(int x, int y) const;
    bool complete(int x, int y) const { return groupsWithSamples(x, y) == spec_.groups; }
    // The sum of the importance of a pixel's samples, which is their number in exact layers; of all, or of a group.
    double expected(int x, int y) const;
    double expected(int x, int y, int group) const;
    // The sum of a channel over all groups, or of one of them.
    double sum(int x, int y, int channel) const;
    double sum(int x, int y, int channel, int group) const { return value(x, y, group, size_t(channel)); }
    // The weighted mean of the first three channels of a group, and of all groups; black without samples.
    Rgb group(int x, int y, int group) const;
    Rgb mean(int x, int y) const;
    // The variance of the mean, from the differences between groups; zero if fewer than two groups have samples. It
    // does not include what all groups share, such as the radiance maps of a pass.
    Rgb varianceOfMean(int x, int y) const;
    // The means times a scale, as an image of the region's size.
    Image image(float scale = 1) const;

    // Adds the other's sums, as if all of its samples had been taken here. Both layers must have the same region and
    // spec.
    void add(const FilmLayer& other);
    // The bytes of a row in memory.
    std::span<std::byte> row(int y);
    std::span<const std::byte> row(int y) const;
    // Copies a row of the same spec; the region of the other layer must contain this one's.
    void copyRow(const FilmLayer& from, int y);

    const PixelRegion& region() const { return region_; }
    const FilmLayerSpec& spec() const { return spec_; }

  private:
    size_t recordSize() const { return size_t(spec_.channels) + (spec_.weighted ? 2 : 0); }
    size_t record(int x, int y, int group) const {
        return (region_.index(x, y) * size_t(spec_.groups) + size_t(group)) * recordSize();
    }
    // Quanta in 1.
    double perQuantum_ = 1;
    bool exact() const { return spec_.storage == FilmLayerSpec::Storage::Exact; }
    // Value `i` of a group's record: the channels, then the sum of the weights, then that of the importance.
    double value(int x, int y, int group, size_t i) const;

    PixelRegion region_{};
    FilmLayerSpec spec_;
    std::vector<int64_t> exact_;  // one of the two is empty
    std::vector<float> single_;
};

}  // namespace drc
