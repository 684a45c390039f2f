// Changes of an example that make another valid example: the symmetries of the map's projection, and permutations of
// the colour channels. Normals turn with the map, which is what makes them exact.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "cache/projection.h"

namespace drc {

// One noisy map and its target. Planar, rows v, columns u; u runs along the map's local x, v along its local y.
struct Example {
    int size = 0;
    std::vector<float> radiance;  // [3][size][size]
    std::vector<float> normal;    // [3][size][size]
    std::vector<float> distance;  // [size][size], -1 on a miss
    std::vector<float> target;    // [3][size][size]
    std::vector<float> albedo;    // [3][size][size]; empty if the data have none, as is
    std::vector<float> direct;    // [3][size][size]

    void resize(int newSize);
};

struct Augmentation {
    // First x and y change places if `transpose`, then x and y change sign.
    bool transpose = false, negateX = false, negateY = false;
    std::array<int, 3> colours{0, 1, 2};  // channel c of the result is channel colours[c] of the source

    // Number `index` of the projection's symmetries, 0 the identity: 8 of the square for equal-area (which are
    // symmetries of the hemisphere there); for latlong only the 4 flips, as its axes are not interchangeable.
    static int symmetries(Projection projection) { return projection == Projection::EqualArea ? 8 : 4; }
    static Augmentation symmetry(int index);
    // Drawn from 64 random bits: any of the projection's symmetries with any permutation of the colours.
    static Augmentation random(Projection projection, uint64_t bits);

    // result must not be source.
    void apply(const Example& source, Example& result) const;
};

}  // namespace drc
