// The sums of radiance cells apart from their table, so that files and machines can exchange them. They are integers of
// 64 bits, so that collections of different samples add up to the same bits in any order.
#pragma once
#include <cstdint>
#include <vector>

#include "base/state_file.h"
#include "cells/cell_grid.h"

namespace drc {

// Identifies a cell: which cube of which size, and whose points and facing it has (CellGrid).
struct CellPlace {
    int32_t cube[3]{};
    uint8_t generation = 0, facing = 0, points = 0;
    auto operator<=>(const CellPlace&) const = default;
};

// The key of the cell in a table.
inline uint64_t keyOf(const CellPlace& place) {
    return CellGrid::keyOf({{place.cube[0], place.cube[1], place.cube[2]}}, place.facing, place.generation,
                           place.points);
}

// CellSums of one cell.
struct CollectedCell {
    CellPlace place;
    uint64_t count = 0;
    int64_t light[3]{}, square = 0;
    int64_t viewFactor[3]{}, position[3]{}, normal[3]{};
    void add(const CollectedCell& other);
    // Takes out a part of the sums; what is left has no deposits if the part has as many.
    void takeOut(const CollectedCell& part);
    // Halves all sums until there are fewer deposits than `most`.
    void reduce(uint64_t most);
};

// The cells of a scene, in the order of their places, each once.
struct CellCollection {
    // Cells that a collection keeps: those with the most deposits, and of as many those that come first.
    static constexpr size_t kMostCells = 1 << 19;

    float size = 0;        // edge of the finest cells before they were ever refined, world units
    int sizes = 0;         // number of nested sizes
    int refined = 0;       // how often all sizes have been halved
    float lightScale = 1;  // sets the unit of the sums, as RadianceCellSettings::lightScale
    Vec3 origin{0.f};      // Scene::origin, which positions are relative to
    uint64_t deposits = 0;
    std::vector<CollectedCell> cells;

    // Adds the deposits of another collection. Throws std::invalid_argument if its cells are not of the same grid and
    // unit.
    void add(const CellCollection& other);
    bool sameGrid(const CellCollection& other) const {
        return size == other.size && sizes == other.sizes && lightScale == other.lightScale && origin == other.origin;
    }
    // Drops the cells beyond kMostCells. To be called once, after all collections have been added, because it depends
    // on their order otherwise. Returns how many it dropped.
    size_t bound();

    void save(StateWriter& to) const;
    // Reads what save() wrote; the file may go on. Throws Error if the values contradict each other.
    static CellCollection load(StateReader& from);
};

}  // namespace drc
