// Interpolation by Catmull-Rom splines between unevenly spaced nodes (PBR 3e, section 8.6.1).
#pragma once
#include <array>
#include <vector>

namespace drc {

// The spline's value at one x as a weighted sum of the values of four nodes, segment - 1 to segment + 2. The weights of
// nodes that do not exist, or that lie beyond a break, are zero.
struct SplineWeights {
    int segment = 0;              // x lies between the nodes `segment` and `segment + 1`
    float t = 0;                  // position within the segment, in [0, 1]
    std::array<float, 4> weight;  // they sum to one

    int node(int i) const { return segment - 1 + i; }
};

class SplineNodes {
  public:
    // nodes: x in ascending order, at least two of them different, no three equal. Two equal neighbours are a break:
    // the parts of the spline on its two sides are independent.
    explicit SplineNodes(std::vector<float> nodes);

    int size() const { return int(nodes_.size()); }
    float operator[](int i) const { return nodes_[size_t(i)]; }
    // x is clamped to the range of the nodes.
    SplineWeights at(float x) const;
    // One weight per node: the integral of the spline is the sum of weight times value over the nodes.
    std::vector<double> integralWeights() const;

  private:
    // Whether there is a node before the segment (after it), not beyond a break, for the slope at the segment's start
    // (end).
    bool hasBefore(int segment) const { return segment > 0 && nodes_[size_t(segment - 1)] < nodes_[size_t(segment)]; }
    bool hasAfter(int segment) const {
        return segment + 2 < size() && nodes_[size_t(segment + 1)] < nodes_[size_t(segment + 2)];
    }

    std::vector<float> nodes_;
};

}  // namespace drc
