#include "math/catmull_rom.h"

#include <algorithm>

namespace drc {

SplineNodes::SplineNodes(std::vector<float> nodes) : nodes_(std::move(nodes)) {}

SplineWeights SplineNodes::at(float x) const {
    const auto above = std::upper_bound(nodes_.begin(), nodes_.end(), x);
    int segment = std::clamp(int(above - nodes_.begin()) - 1, 0, size() - 2);
    // The first or the last two nodes may be a break.
    if (nodes_[size_t(segment)] == nodes_[size_t(segment + 1)]) segment += segment == 0 ? 1 : -1;
    const float x0 = nodes_[size_t(segment)], x1 = nodes_[size_t(segment + 1)], width = x1 - x0;
    const float t = std::clamp((x - x0) / width, 0.f, 1.f), t2 = t * t, t3 = t2 * t;

    // Cubic Hermite interpolation. The slope at a node is that of the line through its two neighbours or, if it has
    // only one, of the segment.
    SplineWeights s{segment, t, {0, 2 * t3 - 3 * t2 + 1, 3 * t2 - 2 * t3, 0}};
    const float slope0 = t3 - 2 * t2 + t, slope1 = t3 - t2;
    if (hasBefore(segment)) {
        const float w = slope0 * width / (x1 - nodes_[size_t(segment - 1)]);
        s.weight[0] -= w;
        s.weight[2] += w;
    } else {
        s.weight[1] -= slope0;
        s.weight[2] += slope0;
    }
    if (hasAfter(segment)) {
        const float w = slope1 * width / (nodes_[size_t(segment + 2)] - x0);
        s.weight[1] -= w;
        s.weight[3] += w;
    } else {
        s.weight[1] -= slope1;
        s.weight[2] += slope1;
    }
    return s;
}

std::vector<double> SplineNodes::integralWeights() const {
    std::vector<double> weights(nodes_.size(), 0.0);
    for (int i = 0; i + 1 < size(); ++i) {
        const size_t k = size_t(i);
        const double width = double(nodes_[k + 1]) - nodes_[k];
        if (width == 0) continue;
        weights[k] += 0.5 * width;
        weights[k + 1] += 0.5 * width;
        // The slopes m0 and m1 at the segment's ends contribute width^2 / 12 (m0 - m1).
        const size_t before = hasBefore(i) ? k - 1 : k, after = hasAfter(i) ? k + 2 : k + 1;
        const double first = width * width / (12 * (double(nodes_[k + 1]) - nodes_[before]));
        const double second = width * width / (12 * (double(nodes_[after]) - nodes_[k]));
        weights[k + 1] += first;
        weights[before] -= first;
        weights[after] -= second;
        weights[k] += second;
    }
    return weights;
}

}  // namespace drc
