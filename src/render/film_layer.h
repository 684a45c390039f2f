// One layer of a film: for each pixel the sum of samples times their filter weights, in one or several independent
// groups. By how much groups differ tells the noise of their mean.
//
// Exact layers keep sums as integers, in units of a quantum, so that any order of additions gives the same bits:
// threads, shards and resumed renders agree. They saturate at 2^63 quanta. Layers in single precision are half as
// large.
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
    bool weighted = true;  // keeps sums of weights too, for means; false: sums alone
    enum class Storage { Exact, Single } storage = Storage::Exact;
    double quantum = 0x1p-24;  // of exact layers; a power of two
    bool operator==(const FilmLayerSpec&) const = default;
    // Of memory for one pixel.
    size_t bytesPerPixel() const;
};

// For radiance in a film that is multiplied by `scale` to be shown: displayed values up to 5e11 in all, in steps of
// 6e-8.
double radianceQuantum(float scale);

// What a sum of values times filter weights is divided by, for a mean: the sum of the weights. A filter with negative
// lobes may sum to nearly nothing over few samples; its expected sum is then the better divisor.
template <typename T>
T filterDivisor(T weights, T expected) {
    return weights > T(0.25) * expected ? weights : expected;
}

class FilmLayer {
  public:
    FilmLayer() = default;
    FilmLayer(const PixelRegion& region, const FilmLayerSpec& spec);

    // weight: of the pixel filter, 1 on average. importance: of all samples of a pass, any positive number; 1 in exact
    // layers. Different pixels may be added to from different threads.
    void add(int x, int y, int group, std::span<const float> values, float weight, float importance = 1);
    void add(int x, int y, int group, const Rgb& value, float weight, float importance = 1) {
        const float values[] = {value.x, value.y, value.z};
        add(x, y, group, values, weight, importance);
    }
    // Of exact layers without weights: to any pixel, from any thread.
    void splat(int x, int y, const Rgb& value);

    // Whether a group has a sample; how many groups do; whether all do.
    bool has(int x, int y, int group) const { return expected(x, y, group) > 0; }
    int groupsWithSamples(int x, int y) const;
    bool complete(int x, int y) const { return groupsWithSamples(x, y) == spec_.groups; }
    // Sum of the importance of a pixel's samples: their number in exact layers.
    double expected(int x, int y) const;
    // The sum of a channel over all groups.
    double sum(int x, int y, int channel) const;
    // The weighted mean of a group's first three channels, and of all; black if there are no samples.
    Rgb group(int x, int y, int group) const;
    Rgb mean(int x, int y) const;
    // Of mean(), from the differences between the groups; zero below two groups with samples. What all groups have in
    // common, such as the radiance maps of a pass, is not in it.
    Rgb varianceOfMean(int x, int y) const;
    // Of the means times a scale. Region-sized.
    Image image(float scale = 1) const;

    // Sums of both: as if all samples had been added here. The layers must have the same region and spec.
    void add(const FilmLayer& other);
    // The row's bytes, as they are kept.
    std::span<std::byte> row(int y);
    std::span<const std::byte> row(int y) const;
    // Copies a row of the same spec; the other's region must contain this one's.
    void copyRow(const FilmLayer& from, int y);

    const PixelRegion& region() const { return region_; }
    const FilmLayerSpec& spec() const { return spec_; }

  private:
    size_t recordSize() const { return size_t(spec_.channels) + (spec_.weighted ? 2 : 0); }
    size_t record(int x, int y, int group) const {
        return (region_.index(x, y) * size_t(spec_.groups) + size_t(group)) * recordSize();
    }
    bool exact() const { return spec_.storage == FilmLayerSpec::Storage::Exact; }
    // Value `i` of a group's record: the channels, then the sum of weights and that of importance.
    double value(int x, int y, int group, size_t i) const;
    double expected(int x, int y, int group) const;

    PixelRegion region_{};
    FilmLayerSpec spec_;
    std::vector<int64_t> exact_;  // or
    std::vector<float> single_;
};

}  // namespace drc
