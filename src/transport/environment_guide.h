// Learns during rendering which parts of an environment actually light the surfaces of a room. Most rooms see only
// those parts of the sky that a few windows show.
//
// Guiding works in primary sample space (Guo et al., "Primary Sample Space Path Guiding", EGSR 2018): it guides the
// random numbers that are mapped to directions of the light, or to directions through the windows of a room. The unit
// square is divided into equal blocks, each of which has an equal share of the light's power, however bright its
// directions are. Surface points are grouped by position and normal. Each group counts how often the samples of each
// block arrived unoccluded, and chooses blocks in proportion to the square root of that rate, which minimises the
// variance. A share of the samples stays unguided, so that no direction is ever excluded.
//
// The counts of one sample pass guide the following passes. Between two calls of update() the density is fixed, so it
// is known exactly for multiple importance sampling and does not depend on the order in which threads count.
#pragma once
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "base/state_file.h"
#include "transport/environment_windows.h"

namespace drc {

class EnvironmentGuide {
  public:
    static constexpr int kRows = 8, kColumns = 16, kBlocks = kRows * kColumns;

    // windows: map random numbers to directions of a light, which must implement inverse(). size: edge length of the
    // voxels that group points, world units.
    EnvironmentGuide(EnvironmentWindows windows, float size);
    EnvironmentGuide(const Light& light, float size) : EnvironmentGuide(EnvironmentWindows(light), size) {}

    const Light* light() const { return &windows_.environment(); }
    // Maps guided random numbers to directions, in place of the light's own sample() and pdf.
    const EnvironmentWindows& windows() const { return windows_; }
    // Group of the points near p with normals near n (unit).
    int group(const Vec3& p, const Vec3& n) const;
    // Prefetches what sample(group, ...) reads.
    void prefetch(int group) const {
        const auto* const table = reinterpret_cast<const char*>(&tables_[size_t(group)]);
        for (size_t i = 0; i < sizeof(Table); i += 64) __builtin_prefetch(table + i);
    }

    struct Guided {
        Vec2 u;             // to be passed to windows().sample()
        float density = 1;  // factor on the pdf of windows().sample(u)
        int slot = 0;       // to be passed to learn()
    };
    // u: uniform on the unit square.
    Guided sample(int group, const Vec2& u) const;
    // The factor Guided::density for a given u.
    float density(int group, const Vec2& u) const;

    // Records whether the sample was unoccluded. Thread-safe.
    void learn(int slot, bool arrived) {
        if (learning_) counts_[size_t(slot)].fetch_add(arrived ? kTry + kArrival : kTry, std::memory_order_relaxed);
    }
    // Rebuilds the sampling densities from the counts (after passes 1, 2, 4, ...). To be called at the end of each
    // sample pass, while no other thread uses the guide.
    void update();

    // Save and restore the learned state, so that a render can resume. load reads what save wrote for a guide of the
    // same light and size, and throws Error if data is missing or invalid; the function that it returns installs the
    // state and cannot fail. Call these only while no other thread uses the guide.
    void save(StateWriter& to) const;
    std::function<void()> load(StateReader& from);

  private:
    static constexpr int kGroups = 1 << 14;
    static constexpr uint64_t kTry = 1,
                              kArrival = 1ull << 32;  // two counts in one number, for a single atomic addition
    // Cumulative probabilities in units of 2^-16: `rows` over the rows of blocks, `columns[row]` over the blocks of a
    // row. The final 1 is not stored.
    struct Table {
        std::array<uint16_t, kRows> rows;
        std::array<std::array<uint16_t, kColumns>, kRows> columns;
    };
    void rebuild(Table& table, const std::atomic<uint64_t>* counts) const;

    EnvironmentWindows windows_;
    float perSize_;
    bool learning_ = true;
    int passes_ = 0;
    std::vector<Table> tables_;
    std::unique_ptr<std::atomic<uint64_t>[]> counts_;  // kGroups x kBlocks
};

}  // namespace drc
