#include "augmentation.h"

#include <utility>

namespace drc {

void Example::resize(int newSize) {
    size = newSize;
    const size_t texels = size_t(size) * size;
    radiance.resize(3 * texels);
    normal.resize(3 * texels);
    distance.resize(texels);
    target.resize(3 * texels);
}

Augmentation Augmentation::symmetry(int index) {
    Augmentation a;
    a.negateX = index & 1;
    a.negateY = index & 2;
    a.transpose = index & 4;
    return a;
}

Augmentation Augmentation::random(Projection projection, uint64_t bits) {
    constexpr std::array<int, 3> kPermutations[6] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    Augmentation a = symmetry(int(bits % uint64_t(symmetries(projection))));
    a.colours = kPermutations[(bits >> 8) % 6];
    return a;
}

void Augmentation::apply(const Example& source, Example& result) const {
    const int n = source.size;
    const size_t texels = size_t(n) * n;
    result.resize(n);
    result.albedo.resize(source.albedo.size());
    result.direct.resize(source.direct.size());
    for (int v = 0; v < n; ++v)
        for (int u = 0; u < n; ++u) {
            int u2 = transpose ? v : u, v2 = transpose ? u : v;
            if (negateX) u2 = n - 1 - u2;
            if (negateY) v2 = n - 1 - v2;
            const size_t from = size_t(v) * n + u, to = size_t(v2) * n + u2;
            for (size_t c = 0; c < 3; ++c) {
                const size_t s = size_t(colours[c]) * texels + from;
                result.radiance[c * texels + to] = source.radiance[s];
                result.target[c * texels + to] = source.target[s];
                if (!source.albedo.empty()) result.albedo[c * texels + to] = source.albedo[s];
                if (!source.direct.empty()) result.direct[c * texels + to] = source.direct[s];
            }
            float x = source.normal[from], y = source.normal[texels + from];
            if (transpose) std::swap(x, y);
            result.normal[to] = negateX ? -x : x;
            result.normal[texels + to] = negateY ? -y : y;
            result.normal[2 * texels + to] = source.normal[2 * texels + from];
            result.distance[to] = source.distance[from];
        }
}

}  // namespace drc
