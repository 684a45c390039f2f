#include "cells/cell_collection.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "cells/radiance_cells.h"
#include "math/rng.h"

namespace drc {
namespace {

using testing::HasSubstr;

constexpr float kFar = 100;

RadianceCellSettings settingsOf() {
    RadianceCellSettings settings;
    settings.size = 0.05f;
    return settings;
}

// Deposits of about the same light, so that none is clamped, on a square metre of floor.
std::vector<CacheDeposit> depositsOf(uint64_t seed, int count = 20000) {
    Pcg32 random(seed);
    std::vector<CacheDeposit> deposits;
    for (int i = 0; i < count; ++i) {
        const Vec3 p(random.nextFloat(), random.nextFloat(), 0);
        const Rgb light(1 + 0.2f * random.nextFloat(), 1, 0.5f + 0.1f * p.x);
        deposits.push_back({{p, Vec3(0, 0, 1), kFar}, light, cacheableFactor(Rgb(0.5f))});
    }
    return deposits;
}

RadianceCells cellsOf(std::initializer_list<uint64_t> seeds) {
    RadianceCells cells(settingsOf());
    for (const uint64_t seed : seeds) {
        std::vector<CacheDeposit> deposits = depositsOf(seed);
        std::vector<CacheDeposit>* const list[] = {&deposits};
        cells.commit(list);
    }
    return cells;
}

std::string bytesOf(const CellCollection& cells) {
    const TemporaryFolder folder;
    StateWriter file(folder.path("cells"), "cells");
    cells.save(file);
    file.commit();
    return readFile(folder.path("cells"));
}

std::vector<float> answersOf(const RadianceCells& cells) {
    std::vector<float> answers;
    for (float x = 0.01f; x < 1; x += 0.02f)
        for (float y = 0.01f; y < 1; y += 0.02f) {
            CacheAnswer answer;
            const bool known = cells.lookUp({Vec3(x, y, 0), Vec3(0, 0, 1), kFar}, answer);
            for (int c = 0; c < 3; ++c) answers.push_back(known ? answer.perFactor[c] : -1);
        }
    return answers;
}

TEST(CellCollection, GivesTheAnswersThatItWasTakenFrom) {
    const RadianceCells cells = cellsOf({1, 2});
    const RadianceCells again(cells.collect(Vec3(0.f)), settingsOf().capacity);
    const std::vector<float> answers = answersOf(cells);
    EXPECT_GT(*std::ranges::min_element(answers), 0);
    EXPECT_EQ(answers, answersOf(again));
    EXPECT_EQ(bytesOf(cells.collect(Vec3(0.f))), bytesOf(again.collect(Vec3(0.f))));
}

TEST(CellCollection, PartsAddUpToTheWholeInAnyOrder) {
    const CellCollection a = cellsOf({1}).collect(Vec3(0.f)), b = cellsOf({2}).collect(Vec3(0.f)),
                         c = cellsOf({3}).collect(Vec3(0.f));
    CellCollection abc = a, cba = c, bc = b, whole = cellsOf({1, 2, 3}).collect(Vec3(0.f));
    abc.add(b);
    abc.add(c);
    cba.add(b);
    cba.add(a);
    bc.add(c);
    bc.add(a);
    EXPECT_EQ(bytesOf(abc), bytesOf(cba));
    EXPECT_EQ(bytesOf(abc), bytesOf(bc));
    EXPECT_EQ(bytesOf(abc), bytesOf(whole));
    CellCollection other = a;
    other.size *= 2;
    EXPECT_THROW(abc.add(other), std::invalid_argument);
}

TEST(CellCollection, ManyDepositsAreReducedInATableAlone) {
    CellCollection all = cellsOf({1}).collect(Vec3(0.f));
    const std::vector<float> answers = answersOf(RadianceCells(all, settingsOf().capacity));
    const uint64_t before = all.cells[0].count;
    for (int i = 0; i < 16; ++i) all.add(CellCollection(all));
    EXPECT_EQ(all.cells[0].count, before << 16);
    const std::vector<float> after = answersOf(RadianceCells(all, settingsOf().capacity));
    // With so many deposits finer cells answer, whose means differ more.
    double mean = 0;
    for (size_t i = 0; i < answers.size(); ++i) {
        EXPECT_NEAR(after[i], answers[i], 0.12f);
        mean += double(after[i] - answers[i]) / double(answers.size());
    }
    EXPECT_NEAR(mean, 0, 0.005);
}

TEST(CellCollection, TheBoundKeepsTheCellsWithMostDeposits) {
    CellCollection all;
    all.size = 1;
    all.sizes = 1;
    const size_t count = CellCollection::kMostCells + 1000;
    for (size_t i = 0; i < count; ++i) {
        CollectedCell cell;
        cell.place.cube[0] = int32_t(i);
        cell.place.generation = CellGrid::kMostRefined;
        cell.count = 1 + i % 7;
        all.cells.push_back(cell);
    }
    EXPECT_EQ(all.bound(), 1000u);
    ASSERT_EQ(all.cells.size(), CellCollection::kMostCells);
    // Of the cells with one deposit, the last ones are left out.
    EXPECT_EQ(std::ranges::count(all.cells, 1u, &CollectedCell::count), int((count + 6) / 7) - 1000);
    EXPECT_EQ(std::ranges::count(all.cells, 2u, &CollectedCell::count), int((count + 5) / 7));
    EXPECT_TRUE(std::ranges::is_sorted(all.cells, {}, &CollectedCell::place));
    EXPECT_EQ(all.bound(), 0u);
}

// Whatever bytes a file has behind a right checksum, it is read or refused.
TEST(CellCollection, NonsenseIsRefused) {
    const TemporaryFolder folder;
    const std::string whole = bytesOf(cellsOf({1}).collect(Vec3(0.f)));
    const auto load = [&](const std::function<void(std::string&)>& change) {
        // Written anew, so that the checksum is right.
        std::string body = whole.substr(whole.find('\n') + 1);
        body.resize(body.size() - sizeof(uint64_t));
        change(body);
        StateWriter file(folder.path("cells"), "cells");
        file.bytes(std::as_bytes(std::span(body)));
        file.commit();
        return errorOf([&] {
            StateReader reader(folder.path("cells"), "cells", "cells");
            const CellCollection all = CellCollection::load(reader);
            reader.finish();
            const RadianceCells cells(all, settingsOf().capacity);
        });
    };
    EXPECT_EQ(load([](std::string&) {}), "");
    EXPECT_THAT(load([](std::string& b) { b.resize(b.size() - 1); }), HasSubstr("damaged"));
    EXPECT_THAT(load([](std::string& b) { b += 'x'; }), HasSubstr("damaged"));
    Pcg32 random(1);
    for (int i = 0; i < 2000; ++i) {
        const std::string error = load([&](std::string& b) {
            const size_t at = i < 1000 ? random.nextUint() % 200 : random.nextUint() % b.size();
            b[at] = char(random.nextUint());
        });
        EXPECT_THAT(error, testing::AnyOf("", HasSubstr("damaged")));
    }
}

}  // namespace
}  // namespace drc
