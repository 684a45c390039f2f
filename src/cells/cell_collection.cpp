#include "cells/cell_collection.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace drc {
namespace {

bool before(const CollectedCell& a, const CollectedCell& b) { return a.place < b.place; }

constexpr size_t kCellBytes = 3 * sizeof(int32_t) + 3 + sizeof(uint64_t) + 13 * sizeof(int64_t);

}  // namespace

void CollectedCell::add(const CollectedCell& other) {
    count += other.count;
    square += other.square;
    for (int c = 0; c < 3; ++c) {
        light[c] += other.light[c];
        viewFactor[c] += other.viewFactor[c];
        position[c] += other.position[c];
        normal[c] += other.normal[c];
    }
}

void CollectedCell::takeOut(const CollectedCell& part) {
    if (count <= part.count) {
        count = 0;
        return;
    }
    count -= part.count;
    square = std::max<int64_t>(0, square - part.square);
    for (int c = 0; c < 3; ++c) {
        light[c] -= part.light[c];
        viewFactor[c] = std::max<int64_t>(0, viewFactor[c] - part.viewFactor[c]);
        position[c] -= part.position[c];
        normal[c] -= part.normal[c];
    }
}

void CollectedCell::reduce(uint64_t most) {
    while (count >= most) {
        count /= 2;
        square /= 2;
        for (int c = 0; c < 3; ++c) {
            light[c] /= 2;
            viewFactor[c] /= 2;
            position[c] /= 2;
            normal[c] /= 2;
        }
    }
}

void CellCollection::add(const CellCollection& other) {
    if (!sameGrid(other)) throw std::invalid_argument("the cells are of another grid");
    refined = std::max(refined, other.refined);
    deposits += other.deposits;
    std::vector<CollectedCell> all;
    all.reserve(cells.size() + other.cells.size());
    auto a = cells.begin();
    for (const CollectedCell& b : other.cells) {
        while (a != cells.end() && before(*a, b)) all.push_back(*a++);
        all.push_back(b);
        if (a != cells.end() && a->place == b.place) all.back().add(*a++);
    }
    all.insert(all.end(), a, cells.end());
    cells = std::move(all);
}

size_t CellCollection::bound() {
    if (cells.size() <= kMostCells) return 0;
    const size_t dropped = cells.size() - kMostCells;
    const auto known = [](const CollectedCell& x, const CollectedCell& y) {
        return x.count != y.count ? x.count > y.count : before(x, y);
    };
    std::nth_element(cells.begin(), cells.begin() + std::ptrdiff_t(kMostCells), cells.end(), known);
    cells.resize(kMostCells);
    std::ranges::sort(cells, before);
    return dropped;
}

void CellCollection::save(StateWriter& to) const {
    to.value(size);
    to.value(int32_t(sizes));
    to.value(int32_t(refined));
    to.value(lightScale);
    for (int c = 0; c < 3; ++c) to.value(origin[c]);
    to.value(deposits);
    to.value(uint64_t(cells.size()));
    for (const CollectedCell& cell : cells) {
        to.values(std::span(cell.place.cube));
        to.value(cell.place.generation);
        to.value(cell.place.facing);
        to.value(cell.place.points);
        to.value(cell.count);
        to.values(std::span(cell.light));
        to.value(cell.square);
        to.values(std::span(cell.viewFactor));
        to.values(std::span(cell.position));
        to.values(std::span(cell.normal));
    }
}

CellCollection CellCollection::load(StateReader& from) {
    CellCollection all;
    all.size = from.value<float>();
    all.sizes = from.value<int32_t>();
    all.refined = from.value<int32_t>();
    all.lightScale = from.value<float>();
    for (int c = 0; c < 3; ++c) all.origin[c] = from.value<float>();
    all.deposits = from.value<uint64_t>();
    const auto count = from.value<uint64_t>();
    if (!(all.size > 0) || !std::isfinite(all.size) || all.sizes < 1 || all.sizes > CellGrid::kMostSizes ||
        all.refined < 0 || all.refined >= CellGrid::kMostRefined || !std::isfinite(all.lightScale) ||
        !isFinite(all.origin) || count > from.remaining() / kCellBytes)
        from.fail("there cannot be such radiance cells");
    all.cells.resize(count);
    const CellGrid grid(all.size, all.sizes);
    for (size_t i = 0; i < count; ++i) {
        CollectedCell& cell = all.cells[i];
        from.values(std::span(cell.place.cube));
        cell.place.generation = from.value<uint8_t>();
        cell.place.facing = from.value<uint8_t>();
        cell.place.points = from.value<uint8_t>();
        cell.count = from.value<uint64_t>();
        from.values(std::span(cell.light));
        cell.square = from.value<int64_t>();
        from.values(std::span(cell.viewFactor));
        from.values(std::span(cell.position));
        from.values(std::span(cell.normal));
        // Levels of a grid that has never been refined.
        const int level = grid.levelOf(cell.place.generation);
        if (level >= grid.levels() || level < -all.refined || cell.place.facing >= CellGrid::kFacings ||
            cell.count == 0 || (i > 0 && !before(all.cells[i - 1], cell)))
            from.fail("there cannot be such a radiance cell");
    }
    return all;
}

}  // namespace drc
