// A tree over many lights, or the many parts of one, to choose one for a point by what each could bring there, in time
// that grows with the depth of the tree alone (Conty Estevez and Kulla 2018; PBR 4e, section 12.6.3).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/light_reach.h"

namespace drc {

class LightTree {
  public:
    LightTree() = default;
    // Lights of no intensity are never chosen.
    explicit LightTree(std::span<const LightReach> lights);

    struct Choice {
        int index = -1;  // into the lights given; -1: none can bring anything
        float probability = 0;
        float uRemapped = 0;  // uniform in [0,1) given index: what is left of the random number
    };
    Choice sample(const Vec3& p, float u) const;
    // Probability with which sample(p) chooses that light.
    float probability(const Vec3& p, int index) const;

    bool empty() const { return nodes_.empty(); }
    // Of all lights together.
    const LightReach& reach() const { return reach_; }
    const LightBound& bound() const { return nodes_.front().bound; }
    int depth() const { return depth_; }

  private:
    struct alignas(64) Node {
        LightBound bound;
        int child = 0;    // the first of two neighbours; negative: ~light
        int parent = -1;  // -1: the root
    };
    static_assert(sizeof(Node) == 64);
    struct Item {
        LightReach reach;
        int light;
    };
    LightReach build(std::span<Item> items, int node, int depth);
    // Probability of the first of a node's two children; negative: neither can bring anything.
    float shareOfFirst(const Node& node, const Vec3& p) const;

    std::vector<Node> nodes_;
    std::vector<int> leaf_;  // of each light; -1: none
    LightReach reach_;
    int depth_ = 0;
};

}  // namespace drc
