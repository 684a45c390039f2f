// Samples of a layer in a few groups, so that by how much the groups differ tells the noise of their mean.
#pragma once
#include <array>
#include <vector>

#include "image/image.h"
#include "scene/scene.h"

namespace drc {

class SampleGroups {
  public:
    static constexpr int kGroups = 4;

    SampleGroups() = default;
    explicit SampleGroups(const PixelRegion& region) : region_(region), pixels_(region.count()) {}

    // group: 0 to kGroups - 1. filterWeight: of the pixel filter, 1 on average. importance: of the pass, any positive
    // number. Different pixels may be added to from different threads.
    void add(int x, int y, int group, const Rgb& value, float filterWeight, float importance = 1);
    // Whether a group has a sample; how many of them do; whether all do.
    bool has(int x, int y, int group) const;
    int count(int x, int y) const;
    bool complete(int x, int y) const { return count(x, y) == kGroups; }
    // The mean of a group's samples by weight and importance, and of all; black if there are none.
    Rgb group(int x, int y, int group) const;
    Rgb mean(int x, int y) const;
    // Of mean(), by how much the groups differ; zero below two groups with samples. What all groups have in common, as
    // the maps of a pass, is not in it.
    Rgb varianceOfMean(int x, int y) const;
    // Of the means. Region-sized.
    Image image() const;
    const PixelRegion& region() const { return region_; }

  private:
    // Single precision: a sum of thousands of samples is still good to a thousandth of its noise.
    struct Sum {
        float value[3] = {0, 0, 0};
        float weight = 0;  // importance times filter weight
        float importance = 0;
        void add(const Sum& s);
        Rgb mean() const;
    };
    PixelRegion region_{};
    std::vector<std::array<Sum, kGroups>> pixels_;
};

}  // namespace drc
