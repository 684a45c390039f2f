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
    const LightBound& bound() const { return bound_; }
    int depth() const { return depth_; }

  private:
    // Eight branches or lights, chosen among at once: a wide tree is shallow, and its branches are weighed side by
    // side.
    struct Node {
        LightBounds bounds;
        int child[LightBounds::kCount]{};  // node; negative: ~light
        int parent = -1;                   // -1: the root
        int branch = 0;                    // of the parent
    };
    struct Leaf {
        int node = -1;  // -1: never chosen
        int branch = 0;
    };
    struct Item {
        LightReach reach;
        int light;
    };
    // The binary tree that the wide one is made of.
    struct Cluster {
        LightReach reach;
        size_t count;
        int child;  // the first of two neighbours; negative: ~light
    };
    static void build(std::vector<Cluster>& clusters, std::span<Item> items, int cluster, int depth);
    void widen(const std::vector<Cluster>& clusters, int cluster, int node, int depth);

    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;  // of each light
    LightReach reach_;
    LightBound bound_;
    int depth_ = 0;
};

}  // namespace drc
