#include "scene/lights/light_tree.h"

#include <array>

#include "math/eight_sums.h"

namespace drc {
namespace {

constexpr int kBuckets = 12;
// For larger numbers of lights, only the longest axis is tried, since merging bounds dominates the build time.
constexpr size_t kTryAllAxes = 4096;
// Beyond this depth, which no useful tree reaches, clusters are simply halved.
constexpr int kDeep = 48;

Vec3 extentOf(const Bounds& b) { return b.empty() ? Vec3(0, 0, 0) : b.max - b.min; }

int longestAxis(const Vec3& v) { return v.x >= v.y && v.x >= v.z ? 0 : v.y >= v.z ? 1 : 2; }

// Cost of a cluster: the product of its intensity, the size of its box and its solid angle of directions. The diagonal
// of the box is included with a small weight, since the box of lights in a row has no surface area.
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
    int axis = -1;   // -1 if there is no split
    int bucket = 0;  // last bucket of the first part
    float cost = kInfinity;
};

}  // namespace

LightTree::LightTree(std::span<const LightReach> lights) : leaves_(lights.size()) {
    std::vector<Item> items;
    for (size_t i = 0; i < lights.size(); ++i)
        if (lights[i].intensity > 0 && !lights[i].bounds.empty()) items.push_back({lights[i], int(i)});
    if (items.empty()) return;
    std::vector<Cluster> clusters;
    clusters.reserve(2 * items.size());
    clusters.resize(1);
    build(clusters, items, 0, 1);
    reach_ = clusters[0].reach;
    bound_ = LightBound(reach_);
    nodes_.resize(1);
    widen(clusters, 0, 0, 1);
}

void LightTree::build(std::vector<Cluster>& clusters, std::span<Item> items, int cluster, int depth) {
    if (items.size() == 1) {
        clusters[size_t(cluster)] = {items[0].reach, 1, ~items[0].light};
        return;
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
        // First the costs of the lights before each boundary between buckets, then those of the lights after it.
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
            // Penalises thin boxes.
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
    const int first = int(clusters.size());
    clusters.resize(clusters.size() + 2);
    build(clusters, items.first(middle), first, depth + 1);
    build(clusters, items.subspan(middle), first + 1, depth + 1);
    clusters[size_t(cluster)] = {merged(clusters[size_t(first)].reach, clusters[size_t(first) + 1].reach), items.size(),
                                 first};
}

void LightTree::widen(const std::vector<Cluster>& clusters, int cluster, int node, int depth) {
    depth_ = std::max(depth_, depth);
    // Repeatedly replaces the largest cluster by its two children until the node is full. They take its position, so
    // that the order of the lights, and with it the stratification of random numbers, is preserved.
    std::vector<int> branches{cluster};
    while (branches.size() < LightBounds::kCount) {
        const auto largest = std::max_element(branches.begin(), branches.end(), [&](int a, int b) {
            return clusters[size_t(a)].count < clusters[size_t(b)].count;
        });
        const int child = clusters[size_t(*largest)].child;
        if (child < 0) break;
        *largest = child;
        branches.insert(largest + 1, child + 1);
    }
    for (size_t i = 0; i < branches.size(); ++i) {
        const Cluster& c = clusters[size_t(branches[i])];
        nodes_[size_t(node)].bounds.set(int(i), LightBound(c.reach));
        if (c.child < 0) {
            nodes_[size_t(node)].child[i] = c.child;
            leaves_[size_t(~c.child)] = {node, int(i)};
            continue;
        }
        const int next = int(nodes_.size());
        nodes_[size_t(node)].child[i] = next;
        nodes_.emplace_back();
        nodes_.back().parent = node;
        nodes_.back().branch = int(i);
        widen(clusters, branches[i], next, depth + 1);
    }
}

LightTree::Choice LightTree::sample(const Vec3& p, float u) const {
    if (nodes_.empty()) return {};
    Choice choice{-1, 1, u};
    for (int node = 0; node >= 0;) {
        float weights[LightBounds::kCount];
        nodes_[size_t(node)].bounds.irradiance(p, weights);
        const EightSums sums(weights);
        if (!(sums.total() > 0)) return {};
        const float target = choice.uRemapped * sums.total();
        int branch = sums.find(target);
        if (branch == EightSums::kCount) branch = sums.last();  // reached only by rounding
        choice.probability *= weights[branch] / sums.total();
        choice.uRemapped = std::clamp((target - sums.before(branch)) / weights[branch], 0.f, kOneMinusEpsilon);
        node = nodes_[size_t(node)].child[branch];
        choice.index = ~node;
    }
    return choice;
}

float LightTree::probability(const Vec3& p, int index) const {
    const Leaf leaf = leaves_[size_t(index)];
    // The product of the probabilities along the path from the leaf to the root; sample() multiplies the same factors
    // on the way down.
    float result = leaf.node < 0 ? 0 : 1;
    for (int node = leaf.node, branch = leaf.branch; node >= 0;) {
        float weights[LightBounds::kCount];
        nodes_[size_t(node)].bounds.irradiance(p, weights);
        const float sum = EightSums(weights).total();
        if (!(sum > 0)) return 0;
        result *= weights[branch] / sum;
        branch = nodes_[size_t(node)].branch;
        node = nodes_[size_t(node)].parent;
    }
    return result;
}

}  // namespace drc
