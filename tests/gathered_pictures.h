// Compares pictures by final gather into radiance cells with the path tracer's.
#pragma once
#include "pictures.h"

namespace drc::test {

struct Comparison {
    int count = 8;                     // pictures of each integrator, of different seeds
    int gatherSpp = 48, pathSpp = 48;  // of each
    int block = 16;                    // the side of the blocks that are compared, pixels
    float cellSize = 0;                // RenderParams::cellSize
};

struct Gathered {
    Estimate blocks, means;          // of pictures with radiance cells
    Estimate pathBlocks, pathMeans;  // of the path tracer's
    double answered = 0;             // share of look-ups at points which the cells accept and that they answer
    double refused = 0;              // share of points that they do not accept

    // Standard error of a difference of blocks, as a share of the path tracer's: the worst.
    double worstError() const {
        double worst = 0;
        for (size_t i = 0; i < blocks.mean.size(); ++i)
            worst = std::max(worst, std::sqrt(combine(blocks, pathBlocks, i).variance) / pathBlocks.mean[i]);
        return worst;
    }
    // worstError() for the means over the picture: the worst channel.
    double meanError() const {
        double worst = 0;
        for (size_t c = 0; c < 3; ++c)
            worst = std::max(worst, std::sqrt(combine(means, pathMeans, c).variance) / pathMeans.mean[c]);
        return worst;
    }
    // The mean square of the blocks' relative differences, less what noise adds to it. May be negative.
    double squaredBias() const {
        double sum = 0;
        for (size_t i = 0; i < blocks.mean.size(); ++i) {
            const double d = blocks.mean[i] - pathBlocks.mean[i];
            sum += (d * d - combine(blocks, pathBlocks, i).variance) / (pathBlocks.mean[i] * pathBlocks.mean[i]);
        }
        return sum / double(blocks.mean.size());
    }
    // Difference of the mean over the picture, as a share of the path tracer's: the worst channel.
    double meanDifference() const {
        double worst = 0;
        for (size_t c = 0; c < 3; ++c) {
            const double d = means.mean[c] / pathMeans.mean[c] - 1;
            if (std::abs(d) > std::abs(worst)) worst = d;
        }
        return worst;
    }
    // The difference of blocks that is largest as a share of the path tracer's.
    double worstDifference() const {
        double worst = 0;
        for (size_t i = 0; i < blocks.mean.size(); ++i) {
            const double d = blocks.mean[i] / pathBlocks.mean[i] - 1;
            if (!(std::abs(d) <= std::abs(worst))) worst = d;
        }
        return worst;
    }
    // Tests for differences of blocks beyond this share.
    ZResult differencesBeyond(double share) const { return zTest(allowing(share, blocks, pathBlocks), pathBlocks); }
};

// Records the figures of a comparison with the test.
inline void record(const Gathered& g) {
    const auto figure = [](const char* name, double x) { testing::Test::RecordProperty(name, std::to_string(x)); };
    figure("worst difference", g.worstDifference());
    figure("worst standard error", g.worstError());
    figure("mean difference", g.meanDifference());
    figure("mean error", g.meanError());
    figure("answered", g.answered);
    figure("refused", g.refused);
}

struct PathPictures {
    Estimate blocks, means;
};
// Path-traced with other random numbers than the cells' pictures have.
inline PathPictures pathPictures(Scene& scene, const Comparison& c) {
    const auto paths = pictures(scene, {.integrator = "path",
                                        .count = c.count,
                                        .spp = c.pathSpp,
                                        .block = c.block,
                                        .change = [](RenderParams& params) { params.seed += 1000; }});
    return {estimateOf(paths), estimateOfMeans(paths)};
}

inline Gathered gather(Scene& scene, const Comparison& c, const PathPictures& paths) {
    Stats stats;
    const auto cells = pictures(scene, {.integrator = "drc",
                                        .count = c.count,
                                        .spp = c.gatherSpp,
                                        .block = c.block,
                                        .change = [&](RenderParams& params) { params.cellSize = c.cellSize; },
                                        .stats = &stats});
    const double answered = double(stats.count("cells/look-ups/answered")),
                 unknown = double(stats.count("cells/look-ups/refused: too little is known")),
                 refused = double(stats.count("cells/look-ups/refused: the segment is short or the lobe narrow"));
    return {estimateOf(cells),
            estimateOfMeans(cells),
            paths.blocks,
            paths.means,
            answered / std::max(1.0, answered + unknown),
            refused / std::max(1.0, answered + unknown + refused)};
}
inline Gathered gather(Scene& scene, const Comparison& c) { return gather(scene, c, pathPictures(scene, c)); }

}  // namespace drc::test
