// Data augmentation: the symmetries of a map's projection and permutations of the colour channels. Normals are
// transformed with the map, so that the result is exactly a map of the transformed scene.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "maps/projection.h"

namespace drc {

// A noisy map and its target. Planar; rows are v and columns u; u runs along the map's local x axis, v along its local
// y axis.
struct Example {
    int size = 0;
    std::vector<float> radiance;  // [3][size][size]
    std::vector<float> normal;    // [3][size][size]
    std::vector<float> distance;  // [size][size], -1 where nothing was hit
    std::vector<float> target;    // [3][size][size]
    std::vector<float> albedo;    // [3][size][size]; empty if the data have none, and `direct` likewise
    std::vector<float> direct;    // [3][size][size]

    void resize(int newSize);
};

struct Augmentation {
    // x and y are exchanged first if `transpose` is set, then negated.
    bool transpose = false, negateX = false, negateY = false;
    std::array<int, 3> colours{0, 1, 2};  // channel c of the result is channel colours[c] of the source

    // Symmetry `index` of the projection; 0 is the identity. The equal-area projection has the 8 symmetries of the
    // square, which are symmetries of the hemisphere. The lat-long projection has only the 4 flips, since its axes
    // cannot be exchanged.
    static int symmetries(Projection projection) { return projection == Projection::EqualArea ? 8 : 4; }
    static Augmentation symmetry(int index);
    // Chooses a symmetry of the projection and a permutation of the colours by 64 random bits.
    static Augmentation random(Projection projection, uint64_t bits);

    // result must be another object than source.
    void apply(const Example& source, Example& result) const;
};

}  // namespace drc
