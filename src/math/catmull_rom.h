// Interpolation by Catmull-Rom splines between unevenly spaced nodes (PBR 3e, section 8.6.1).
#pragma once
#include <array>
#include <vector>

namespace drc {

// The spline at one place, as a weighted sum of the values of four neighbouring nodes: segment - 1 to segment + 2. The
// weights of nodes that do not exist, or that lie beyond a break, are zero.
struct SplineWeights {
    int segment = 0;              // the place lies between the nodes `segment` and `segment + 1`
    float t = 0;                  // position within the segment, in [0, 1]
    std::array<float, 4> weight;  // they sum to one

    int node(int i) const { return segment - 1 + i; }
};

class SplineNodes {
  public:
    // In ascending order, at least two of them different. Two equal neighbours are a break: the spline's parts on
    // either side do not know of each other. No three are equal.
    explicit SplineNodes(std::vector<float> nodes);

    int size() const { return int(nodes_.size()); }
    float operator[](int i) const { return nodes_[size_t(i)]; }
    // Places beyond the first and the last node count as those.
    SplineWeights at(float x) const;
    // The integral of the spline is the sum of these times the nodes' values.
    std::vector<double> integralWeights() const;

  private:
    // Whether the slope at a segment's end is known from a node beyond that end.
    bool hasBefore(int segment) const { return segment > 0 && nodes_[size_t(segment - 1)] < nodes_[size_t(segment)]; }
    bool hasAfter(int segment) const {
        return segment + 2 < size() && nodes_[size_t(segment + 1)] < nodes_[size_t(segment + 2)];
    }

    std::vector<float> nodes_;
};

}  // namespace drc
