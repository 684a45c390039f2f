// Learns, while a picture is rendered, from which parts of an environment light comes to the surfaces of a room: of the
// sky that the scene's file describes, most rooms see what a few windows show.
//
// The random numbers that the light turns into directions are guided, not the directions: the unit square of its
// sample(u) is divided into equal blocks, each with an equal part of the light's power however bright or small its
// directions are (the primary sample space of Guo et al., "Primary Sample Space Path Guiding", EGSR 2018). Points are
// grouped by position and by the way that they face; each group counts how often samples of a block arrived, and
// chooses blocks in proportion to the root of that rate, which is what makes the variance of such samples least. A part
// of all samples stays as it would be without a guide, so that no direction is ever left out.
//
// The counts of one sweep guide the next ones: between two update()s the density is fixed, it is known exactly for
// multiple importance sampling, and it does not depend on the order in which threads count.
#pragma once
#include <array>
#include <atomic>
#include <memory>
#include <vector>

#include "scene/light.h"

namespace drc {

class EnvironmentGuide {
  public:
    static constexpr int kRows = 8, kColumns = 16, kBlocks = kRows * kColumns;

    // light: at infinity, and one whose samples can be inverted. size: edge of the voxels that points are grouped by,
    // world units.
    EnvironmentGuide(const Light& light, float size);

    const Light* light() const { return &light_; }
    // Of points about p that face n (unit).
    int group(const Vec3& p, const Vec3& n) const;
    // Starts to fetch from memory what sample(group, ...) reads.
    void prefetch(int group) const {
        const auto* const table = reinterpret_cast<const char*>(&tables_[size_t(group)]);
        for (size_t i = 0; i < sizeof(Table); i += 64) __builtin_prefetch(table + i);
    }

    struct Guided {
        Vec2 u;             // for Light::sample
        float density = 1;  // by which the light's own density is to be multiplied
        int slot = 0;       // for learn()
    };
    // u: uniform in the unit square.
    Guided sample(int group, const Vec2& u) const;
    // Guided::density of a sample with this u.
    float density(int group, const Vec2& u) const;

    // Whether a sample brought light. From any thread.
    void learn(int slot, bool arrived) {
        if (learning_) counts_[size_t(slot)].fetch_add(arrived ? kTry + kArrival : kTry, std::memory_order_relaxed);
    }
    // Takes what was learned into use, at a sweep's end.
    void update();

  private:
    static constexpr int kGroups = 1 << 14;
    static constexpr uint64_t kTry = 1, kArrival = 1ull << 32;  // counted together: one write for each sample
    // Cumulative probabilities in units of 2^-16: of the rows of blocks, and within each row; without the last, which
    // is one.
    struct Table {
        std::array<uint16_t, kRows> rows;
        std::array<std::array<uint16_t, kColumns>, kRows> columns;
    };
    void rebuild(Table& table, const std::atomic<uint64_t>* counts) const;

    const Light& light_;
    float perSize_;
    bool learning_ = true;
    int sweeps_ = 0;
    std::vector<Table> tables_;
    std::unique_ptr<std::atomic<uint64_t>[]> counts_;  // kGroups x kBlocks
};

}  // namespace drc
