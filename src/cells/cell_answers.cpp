#include "cells/cell_answers.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <vector>

#include "base/parallel.h"

namespace drc {
namespace {

// Factor on the number of deposits that a cell needs if its points have a short reach.
constexpr uint32_t kNearby = 16;
// The relative error of an answer is related to its luminance, but at least to this share of the mean over all cells.
constexpr double kDimmest = 0.25;
// Cells that a thread works on at a time.
constexpr int kPiece = 1 << 12;

class Renewal {
  public:
    Renewal(CellTable& table, const CellGrid& grid, const CellStatistics& statistics,
            const CellAnswerSettings& settings)
        : table_(table),
          grid_(grid),
          statistics_(statistics),
          settings_(settings),
          links_(table.size()),
          pieces_((table.size() + kPiece - 1) / kPiece) {}

    CellTotals totals() {
        forEachPiece([&](Piece& piece, size_t begin, size_t end) { findLarger(piece, begin, end); });
        CellTotals all;
        int64_t light = 0, count = 0;
        for (const Piece& piece : pieces_) {
            light += piece.light;
            count += piece.count;
            all.used += piece.used;
        }
        all.any = count > 0;
        if (all.any) all.mean = double(light) / statistics_.perCoarseUnit() / double(count);
        mean_ = all.mean;

        forEachPiece([&](Piece&, size_t begin, size_t end) {
            for (size_t cell = begin; cell < end; ++cell) {
                if (table_.answer(cell).key == 0) continue;
                CellSums& sums = table_.sums(cell);
                links_[cell].enough = knowsEnough(cell);
                links_[cell].divides = links_[cell].enough && divides(sums);
                sums.within = sums.countWithin = 0;  // for the next renewal
            }
        });
        forEachPiece([&](Piece& piece, size_t begin, size_t end) { answer(piece, begin, end); });
        int64_t errors = 0;
        for (const Piece& piece : pieces_) errors += piece.errors;
        if (all.any) all.error = double(errors) / kPerError / double(count);
        return all;
    }

  private:
    // Facts about a cell that are determined before its answer is renewed.
    struct Link {
        uint32_t larger : 30 = kNone;  // index of the cell of the next larger size around it
        uint32_t enough : 1 = 0;       // whether it has enough deposits to answer
        uint32_t divides : 1 = 0;      // and whether the cells within it answer instead, where they have enough
    };
    static constexpr uint32_t kNone = (1u << 30) - 1;
    static constexpr double kPerError = 0x1p10;
    // Sums over a piece of the table. They are integers, so that the order of additions does not matter. All but `used`
    // are taken over the cells of the smallest size alone, because these contain each deposit exactly once.
    struct alignas(64) Piece {
        int64_t light = 0, count = 0, errors = 0;
        size_t used = 0;
    };

    template <class F>
    void forEachPiece(const F& f) {
        parallelFor(0, int(pieces_.size()), 1, [&](int begin, int end) {
            for (auto k = size_t(begin); k < size_t(end); ++k)
                f(pieces_[k], k * kPiece, std::min(table_.size(), (k + 1) * kPiece));
        });
    }

    bool isSmallest(const CellSums& sums) const { return grid_.levelOf(int(sums.generation)) == 0; }

    // Links each cell to the larger cell around it, and adds its deposits' squared deviations to that cell's sum.
    // Nearly all of the time would be spent waiting for memory, so the cells of a batch are prefetched before any is
    // read.
    void findLarger(Piece& piece, size_t begin, size_t end) {
        struct Around {
            uint64_t key;
            size_t cell;
        };
        std::array<Around, CellTable::kBatch> batch;
        size_t waiting = 0;
        const auto addToLarger = [&] {
            for (size_t k = 0; k < waiting; ++k) {
                const size_t larger = batch[k].key != 0 ? table_.find(batch[k].key) : CellTable::kNone;
                links_[batch[k].cell].larger = larger != CellTable::kNone ? uint32_t(larger) : kNone;
                if (larger != CellTable::kNone) __builtin_prefetch(&table_.sums(larger).within, 1);
            }
            for (size_t k = 0; k < waiting; ++k) {
                const uint32_t larger = links_[batch[k].cell].larger;
                if (larger == kNone) continue;
                const CellSums& sums = table_.sums(batch[k].cell);
                CellSums& its = table_.sums(larger);
                std::atomic_ref(its.within).fetch_add(statistics_.squaredDeviations(sums), std::memory_order_relaxed);
                std::atomic_ref(its.countWithin).fetch_add(uint32_t(sums.count), std::memory_order_relaxed);
            }
            waiting = 0;
        };
        for (size_t cell = begin; cell < end; ++cell) {
            if (table_.answer(cell).key == 0) continue;
            const CellSums& sums = table_.sums(cell);
            ++piece.used;
            if (isSmallest(sums)) {
                piece.light +=
                    CellStatistics::unitsOf(statistics_.mean(sums) * double(sums.count), statistics_.perCoarseUnit());
                piece.count += int64_t(sums.count);
            }
            const uint64_t key =
                grid_.keyAround(sums.cube, int(sums.facing), int(sums.generation), table_.answer(cell).points);
            if (key != 0) table_.prefetch(key);
            batch[waiting++] = {key, cell};
            if (waiting == CellTable::kBatch) addToLarger();
        }
        addToLarger();
    }

    // A cell that is seen from nearby appears in few pixels, where its noise would stand out, so it needs more
    // deposits.
    bool knowsEnough(size_t cell) const {
        const uint32_t times = table_.answer(cell).points == 0 ? 1 : kNearby;
        return table_.sums(cell).count >= uint32_t(settings_.deposits) * times;
    }

    // Whether the means of the cells within this one would be accurate enough. These cells share its deposits. Their
    // variance is compared with the square of this cell's mean, because viewers see them together. It is taken about
    // each cell's own mean: differences between the means are not noise, but the detail that smaller cells are there to
    // show.
    bool divides(const CellSums& sums) const {
        const double count = double(sums.countWithin), mean = statistics_.mean(sums);
        constexpr double kCellsWithin = 4;
        return kCellsWithin * statistics_.summedVarianceWithin(sums) <=
               double(settings_.variance) * mean * mean * count * count;
    }

    // The cell whose answer a cell gets, or kNone. The search starts at the largest cell around it and goes on to
    // smaller ones, as long as each may be divided. The larger cell decides for all cells within it: if each decided by
    // its own variance, or by that of a part, cells that happen to lack their brightest samples would be preferred, and
    // light would be lost.
    uint32_t sourceOf(size_t cell) const {
        std::array<uint32_t, CellGrid::kMostSizes> nested{uint32_t(cell)};
        size_t sizes = 1;
        for (uint32_t larger; sizes < nested.size() && (larger = links_[nested[sizes - 1]].larger) != kNone;)
            nested[sizes++] = larger;
        uint32_t source = kNone;
        while (sizes-- > 0) {
            if (!links_[nested[sizes]].enough) continue;
            if (source != kNone && !links_[source].divides) break;
            source = nested[sizes];
        }
        return source;
    }

    void answer(Piece& piece, size_t begin, size_t end) {
        struct Source {
            uint32_t source;
            size_t cell;
        };
        std::array<Source, CellTable::kBatch> batch;
        size_t waiting = 0;
        const auto answerAll = [&] {
            for (size_t k = 0; k < waiting; ++k) {
                const auto [source, cell] = batch[k];
                CellAnswer& answer = table_.answer(cell);
                const double error = source == kNone ? 1 : renewAnswer(answer, table_.sums(source));
                if (source == kNone) answer.known = false;
                const CellSums& own = table_.sums(cell);
                if (isSmallest(own)) piece.errors += std::llrint(std::min(error, 4.0) * kPerError) * int64_t(own.count);
            }
            waiting = 0;
        };
        for (size_t cell = begin; cell < end; ++cell) {
            if (table_.answer(cell).key == 0) continue;
            const uint32_t source = sourceOf(cell);
            if (source != kNone && source != cell) {
                const auto* sums = reinterpret_cast<const char*>(&table_.sums(source));
                __builtin_prefetch(sums);
                __builtin_prefetch(sums + 64);
            }
            batch[waiting++] = {source, cell};
            if (waiting == CellTable::kBatch) answerAll();
        }
        answerAll();
    }

    // Renews the answer of a cell from the sums of its source cell. Returns the relative standard error of the answer.
    double renewAnswer(CellAnswer& answer, const CellSums& sums) const {
        answer.known = false;
        const auto vector = [](const int32_t(&v)[3]) { return Vec3(float(v[0]), float(v[1]), float(v[2])); };
        const float length2 = lengthSquared(vector(sums.normal));
        if (!(length2 > 0)) return 1;
        const Vec3 normal = vector(sums.normal) * (1 / std::sqrt(length2));
        for (int c = 0; c < 3; ++c) answer.normal[c] = int8_t(std::lrint(normal[c] * kCellNormalUnits));
        // The plane is computed with the quantised normal, which is the one that look-ups use.
        const Vec3 seen = Vec3(answer.normal[0], answer.normal[1], answer.normal[2]) * (1 / kCellNormalUnits);
        const int level = grid_.levelOf(int(sums.generation));
        const float perUnit = grid_.sizeOf(level) / (kCellPositionUnits * float(sums.count));
        answer.plane = dot(seen, grid_.cornerOf(sums.cube, level) + vector(sums.position) * perUnit);
        const Rgb value = statistics_.perFactor(sums);
        for (int c = 0; c < 3; ++c) answer.perFactor[c] = value[c];
        answer.known = true;
        const double mean = double(luminance(value));
        return std::sqrt(statistics_.variance(sums, mean) / double(sums.count)) /
               std::max(1e-30, std::max(mean, kDimmest * mean_));
    }

    CellTable& table_;
    const CellGrid& grid_;
    const CellStatistics& statistics_;
    const CellAnswerSettings& settings_;
    HugeArray<Link> links_;
    std::vector<Piece> pieces_;
    double mean_ = 0;
};

}  // namespace

CellTotals renewCellAnswers(CellTable& table, const CellGrid& grid, const CellStatistics& statistics,
                            const CellAnswerSettings& settings) {
    return Renewal(table, grid, statistics, settings).totals();
}

}  // namespace drc
