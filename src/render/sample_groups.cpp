#include "render/sample_groups.h"

#include <algorithm>

#include "render/film.h"

namespace drc {

void SampleGroups::Sum::add(const Sum& s) {
    for (int c = 0; c < 3; ++c) value[c] += s.value[c];
    weight += s.weight;
    importance += s.importance;
}

Rgb SampleGroups::Sum::mean() const {
    if (importance == 0) return Rgb(0.f);
    const float divisor = filterDivisor(weight, importance);
    return Rgb(value[0] / divisor, value[1] / divisor, value[2] / divisor);
}

void SampleGroups::add(int x, int y, int group, const Rgb& value, float filterWeight, float importance) {
    const float weight = importance * filterWeight;
    const Sum one{{value.x * weight, value.y * weight, value.z * weight}, weight, importance};
    pixels_[region_.index(x, y)][size_t(group)].add(one);
}

bool SampleGroups::has(int x, int y, int group) const {
    return pixels_[region_.index(x, y)][size_t(group)].importance > 0;
}

int SampleGroups::count(int x, int y) const {
    const auto& groups = pixels_[region_.index(x, y)];
    return int(std::count_if(groups.begin(), groups.end(), [](const Sum& s) { return s.importance > 0; }));
}

Rgb SampleGroups::group(int x, int y, int group) const { return pixels_[region_.index(x, y)][size_t(group)].mean(); }

Rgb SampleGroups::mean(int x, int y) const {
    Sum sum;
    for (const Sum& s : pixels_[region_.index(x, y)]) sum.add(s);
    return sum.mean();
}

Rgb SampleGroups::varianceOfMean(int x, int y) const {
    const Rgb all = mean(x, y);
    Rgb sum(0.f);
    float importance = 0;
    int count = 0;
    for (const Sum& s : pixels_[region_.index(x, y)]) {
        if (s.importance == 0) continue;
        const Rgb difference = (s.mean() - all) * s.importance;
        sum += difference * difference;
        importance += s.importance;
        ++count;
    }
    if (count < 2) return Rgb(0.f);
    return sum * (float(count) / (float(count - 1) * importance * importance));
}

Image SampleGroups::image() const {
    Image image(region_.width(), region_.height());
    for (int y = 0; y < region_.height(); ++y)
        for (int x = 0; x < region_.width(); ++x) image.setRgb(x, y, mean(region_.x0 + x, region_.y0 + y));
    return image;
}

}  // namespace drc
