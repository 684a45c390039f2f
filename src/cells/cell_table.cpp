#include "cells/cell_table.h"

#include "base/parallel.h"

namespace drc {

size_t CellTable::claim(uint64_t key, uint32_t now) const {
    const auto age = [&](size_t cell) { return uint16_t(now - answers_[cell].lastUse); };
    // A cell that was cleared may leave an empty place before the key's own cell.
    if (const size_t known = find(key); known != kNone) return known;
    const size_t first = bucketOf(key) * kWays;
    size_t oldest = first;
    for (size_t cell = first; cell < first + kWays; ++cell) {
        if (answers_[cell].key == 0) return cell;
        if (age(cell) > age(oldest)) oldest = cell;
    }
    return age(oldest) <= 1 ? kNone : oldest;
}

// All cells of a new bucket come from a single old bucket, so that old buckets can be moved in parallel, and cells keep
// their order.
void CellTable::grow(size_t cells) {
    constexpr int kBuckets = 1 << 10;
    CellTable larger(cells);
    parallelFor(0, int(buckets()), kBuckets, [&](int begin, int end) {
        for (size_t from = size_t(begin) * kWays; from < size_t(end) * kWays; ++from) {
            if (answers_[from].key == 0) continue;
            size_t to = larger.bucketOf(answers_[from].key) * kWays;
            while (larger.answers_[to].key != 0) ++to;
            larger.answers_[to] = answers_[from];
            larger.sums_[to] = sums_[from];
        }
    });
    *this = std::move(larger);
}

}  // namespace drc
