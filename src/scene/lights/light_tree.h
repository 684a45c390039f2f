// A tree over many lights, or over the many parts of one light. It chooses a light for a point in proportion to the
// estimated contribution, in time proportional to the depth of the tree (Conty Estevez and Kulla 2018; PBR 4e, section
// 12.6.3).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/lights/light_reach.h"

namespace drc {

class LightTree {
  public:
    LightTree() = default;
    // Lights with zero intensity or empty bounds are never chosen.
    explicit LightTree(std::span<const LightReach> lights);

    struct Choice {
        int index = -1;  // into the lights given; -1 if none can contribute
        float probability = 0;
        float uRemapped = 0;  // the unused part of the random number: uniform in [0,1) given index
    };
    Choice sample(const Vec3& p, float u) const;
    // Probability with which sample(p) chooses the light.
    float probability(const Vec3& p, int index) const;

    bool empty() const { return nodes_.empty(); }
    // Bounds of all lights together.
    const LightReach& reach() const { return reach_; }
    const LightBound& bound() const { return bound_; }
    int depth() const { return depth_; }

  private:
    // A node with up to eight children, each a node or a light, which are weighted in SIMD. A wide tree is shallow.
    struct Node {
        LightBounds bounds;
        int child[LightBounds::kCount]{};  // index of a node, or ~index of a light if negative
        int parent = -1;                   // -1 for the root
        int branch = 0;                    // index among the parent's children
    };
    struct Leaf {
        int node = -1;  // -1 if the light is never chosen
        int branch = 0;
    };
    struct Item {
        LightReach reach;
        int light;
    };
    // A node of the binary tree from which the wide tree is made.
    struct Cluster {
        LightReach reach;
        size_t count;
        int child;  // index of the first of two adjacent children, or ~index of a light if negative
    };
    static void build(std::vector<Cluster>& clusters, std::span<Item> items, int cluster, int depth);
    void widen(const std::vector<Cluster>& clusters, int cluster, int node, int depth);

    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;  // for each light, its position in the tree
    LightReach reach_;
    LightBound bound_;
    int depth_ = 0;
};

}  // namespace drc
