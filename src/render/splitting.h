// Decides how many light samples and gather rays share each camera hit of final gather, for blocks of pixels, from the
// noise that earlier samples have found there.
//
// A camera sample of cost c and variance v, of which n rays of cost r add a variance of w / n, has the least product of
// cost and variance with n = sqrt(w c / (v r)): splitting as of Arvo & Kirk, "Particle Transport and Image Synthesis"
// (1990). v and c are those of the whole picture, because each pixel has the same number of camera samples; w is the
// block's. Variances are relative to the squared radiance of the block, as the eye sees them.
#pragma once
#include <vector>

#include "base/state_file.h"
#include "integrators/final_gather.h"
#include "scene/scene.h"

namespace drc {

class SplitPlanner {
  public:
    static constexpr int kBlock = 32;  // pixels
    static constexpr int kMostRays = 16, kMostLights = 8;

    // displayScale: by which radiance is multiplied for display. firstSample: index of the picture's first camera
    // sample.
    SplitPlanner(const PixelRegion& region, float displayScale, uint32_t firstSample);

    // For a camera sample of a pixel.
    FinalGather::Splitting at(int x, int y) const { return blocks_[blockOf(x, y)].plan; }
    // Whether add() wants the mean of a row's pixels.
    static bool wantsMean(int y) { return y % kRowsForMean == 0; }
    // Records a camera sample that was taken as at() says. value: its luminance. mean: that of the pixel's `samples`
    // earlier ones, if wantsMean(). Different rows may be added to from different threads.
    void add(int x, int y, const FinalGather::Noise& noise, float value, float mean, double samples);
    // Plans the next samples, when each pixel has so many. wholeSample: the latest pass was the last one of a sample.
    void update(int samples, bool wholeSample);

    void save(StateWriter& to) const;
    // Reads what save() wrote into an object that was made with the same arguments.
    void load(StateReader& from);

  private:
    static constexpr int kRowsForMean = 4;
    struct Sums {
        double lights = 0, rays = 0;        // variances
        double lightHits = 0, rayHits = 0;  // how many
        double value = 0, values = 0;
        // Of a sample's difference from the pixel's mean; the part of it that more light samples and rays would lessen.
        double square = 0, splitSquare = 0, squares = 0;
        void add(const Sums& other);
        void save(StateWriter& to) const;
        void load(StateReader& from);
    };
    struct Block {
        Sums sums;
        FinalGather::Splitting plan;
    };
    int columns() const { return (region_.width() + kBlock - 1) / kBlock; }
    size_t blockOf(int x, int y) const {
        return size_t((y - region_.y0) / kBlock) * size_t(columns()) + size_t((x - region_.x0) / kBlock);
    }

    PixelRegion region_;
    float scale_;
    std::vector<Block> blocks_;
    std::vector<Sums> rows_;  // of the present pass, by row and column of blocks
};

}  // namespace drc
