// The Morton (Z) curve over a square grid. Cells that are close along the curve are close on the grid, so that
// well-distributed numbers along the curve give well-distributed cells.
#pragma once
#include <cstdint>

namespace drc {

struct GridCell {
    int column, row;
};

// Interleaves the bits of column and row, both below 2^16. The indices of a grid of 2^k x 2^k cells are 0 ... 4^k - 1.
inline uint32_t mortonIndex(GridCell cell) {
    const auto spread = [](uint32_t v) {
        v = (v | (v << 8)) & 0x00ff00ffu;
        v = (v | (v << 4)) & 0x0f0f0f0fu;
        v = (v | (v << 2)) & 0x33333333u;
        return (v | (v << 1)) & 0x55555555u;
    };
    return spread(uint32_t(cell.column)) | (spread(uint32_t(cell.row)) << 1);
}

inline GridCell mortonCell(uint32_t index) {
    const auto gather = [](uint32_t v) {
        v &= 0x55555555u;
        v = (v | (v >> 1)) & 0x33333333u;
        v = (v | (v >> 2)) & 0x0f0f0f0fu;
        v = (v | (v >> 4)) & 0x00ff00ffu;
        return int((v | (v >> 8)) & 0x0000ffffu);
    };
    return {gather(index), gather(index >> 1)};
}

}  // namespace drc
