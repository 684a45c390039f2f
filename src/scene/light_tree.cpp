#include "scene/light_tree.h"

#include <array>

namespace drc {
namespace {

constexpr int kBuckets = 12;
// Above this many lights only the longest axis is tried: merging reaches is what building costs.
constexpr size_t kTryAllAxes = 4096;
// Deeper than any useful tree: from here on halves.
constexpr int kDeep = 48;

Vec3 extentOf(const Bounds& b) { return b.empty() ? Vec3(0, 0, 0) : b.max - b.min; }

int longestAxis(const Vec3& v) { return v.x >= v.y && v.x >= v.z ? 0 : v.y >= v.z ? 1 : 2; }

// What a cluster costs: how much light, from how large a box, into how many directions. The diagonal counts a little,
// for lights in a row have no surface.
float cost(const LightReach& r) {
    const Vec3 e = extentOf(r.bounds);
    const float surface = 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
    return r.intensity * orientationMeasure(r) * (surface + 0.1f * lengthSquared(e));
}

struct Bucket {
    LightReach reach;
    size_t count = 0;
    void add(const LightReach& r, size_t n) {
        reach = count == 0 ? r : merged(reach, r);
        count += n;
    }
};

int bucketOf(float x, float low, float extent) {
    return std::clamp(int((x - low) / extent * kBuckets), 0, kBuckets - 1);
}

struct Split {
    int axis = -1;   // -1: none
    int bucket = 0;  // the last of the first part
    float cost = kInfinity;
};

}  // namespace

LightTree::LightTree(std::span<const LightReach> lights) : leaf_(lights.size(), -1) {
    std::vector<Item> items;
    for (size_t i = 0; i < lights.size(); ++i)
        if (lights[i].intensity > 0 && !lights[i].bounds.empty()) items.push_back({lights[i], int(i)});
    if (items.empty()) return;
    nodes_.reserve(2 * items.size());
    nodes_.resize(1);
    reach_ = build(items, 0, 1);
}

LightReach LightTree::build(std::span<Item> items, int node, int depth) {
    depth_ = std::max(depth_, depth);
    if (items.size() == 1) {
        nodes_[size_t(node)].bound = LightBound(items[0].reach);
        nodes_[size_t(node)].child = ~items[0].light;
        leaf_[size_t(items[0].light)] = node;
        return items[0].reach;
    }
    Bounds centers;
    for (const Item& item : items) centers.extend(item.reach.bounds.center());
    const Vec3 extent = extentOf(centers);
    const int longest = longestAxis(extent);
    Split best;
    for (int axis = 0; axis < 3 && depth < kDeep; ++axis) {
        if (!(extent[axis] > 0) || (axis != longest && items.size() > kTryAllAxes)) continue;
        std::array<Bucket, kBuckets> buckets;
        for (const Item& item : items)
            buckets[size_t(bucketOf(item.reach.bounds.center()[axis], centers.min[axis], extent[axis]))].add(item.reach,
                                                                                                             1);
        // Costs of the parts before each boundary, then those after it.
        std::array<float, kBuckets> before{};
        Bucket sum;
        for (size_t i = 0; i < kBuckets; ++i) {
            if (buckets[i].count > 0) sum.add(buckets[i].reach, buckets[i].count);
            before[i] = sum.count > 0 && sum.count < items.size() ? cost(sum.reach) : -1;
        }
        sum = {};
        for (size_t i = kBuckets - 1; i > 0; --i) {
            if (buckets[i].count > 0) sum.add(buckets[i].reach, buckets[i].count);
            if (before[i - 1] < 0 || sum.count == 0) continue;
            // Thin boxes are bad clusters.
            const float c = (before[i - 1] + cost(sum.reach)) * extent[longest] / extent[axis];
            if (c < best.cost) best = {axis, int(i) - 1, c};
        }
    }
    size_t middle = items.size() / 2;
    if (best.axis >= 0) {
        const auto second = std::partition(items.begin(), items.end(), [&](const Item& item) {
            return bucketOf(item.reach.bounds.center()[best.axis], centers.min[best.axis], extent[best.axis]) <=
                   best.bucket;
        });
        middle = size_t(second - items.begin());
    } else {
        std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(middle), items.end(),
                         [longest](const Item& a, const Item& b) {
                             return a.reach.bounds.center()[longest] < b.reach.bounds.center()[longest];
                         });
    }
    const int first = int(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    for (const int child : {first, first + 1}) nodes_[size_t(child)].parent = node;
    const LightReach a = build(items.first(middle), first, depth + 1);
    const LightReach b = build(items.subspan(middle), first + 1, depth + 1);
    const LightReach reach = merged(a, b);
    nodes_[size_t(node)].bound = LightBound(reach);
    nodes_[size_t(node)].child = first;
    return reach;
}

float LightTree::shareOfFirst(const Node& node, const Vec3& p) const {
    const float a = nodes_[size_t(node.child)].bound.irradiance(p);
    const float b = nodes_[size_t(node.child) + 1].bound.irradiance(p);
    return a + b > 0 ? a / (a + b) : -1;
}

LightTree::Choice LightTree::sample(const Vec3& p, float u) const {
    if (nodes_.empty()) return {};
    Choice choice{-1, 1, u};
    const Node* node = nodes_.data();
    while (node->child >= 0) {
        const float share = shareOfFirst(*node, p);
        if (share < 0) return {};
        const bool first = choice.uRemapped < share;
        const float probability = first ? share : 1 - share;
        choice.probability *= probability;
        choice.uRemapped =
            std::min((first ? choice.uRemapped : choice.uRemapped - share) / probability, kOneMinusEpsilon);
        node = &nodes_[size_t(node->child) + (first ? 0 : 1)];
    }
    choice.index = ~node->child;
    return choice;
}

float LightTree::probability(const Vec3& p, int index) const {
    const int leaf = leaf_[size_t(index)];
    if (leaf < 0) return 0;
    // From the leaf upwards: the same factors as on the way down.
    float result = 1;
    for (int i = leaf; nodes_[size_t(i)].parent >= 0;) {
        const int parent = nodes_[size_t(i)].parent;
        const float share = shareOfFirst(nodes_[size_t(parent)], p);
        if (share < 0) return 0;
        result *= i == nodes_[size_t(parent)].child ? share : 1 - share;
        i = parent;
    }
    return result;
}

}  // namespace drc
