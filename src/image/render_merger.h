// Merges renders of one scene that were made with different seeds, as if all samples had been taken in one render.
#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "image/picture_file.h"

namespace drc {

// Each pixel is the mean of the renders' pixels, weighted by their sample counts n: those of the layer "Debug Sample
// Count" or, in files without it, the metadata drc:spp. The counts are added. The variance of a mean of independent
// means m_i is sum n_i^2 var(m_i) / (sum n_i)^2; a render with fewer than two samples in a pixel has no variance there,
// and its samples are assumed to have the same variance as those of the others. If no render has a variance, that of a
// single sample is estimated from the differences of the k renders: sum n_i (m_i - m)^2 / (k - 1). Renders whose pixel
// is NaN or infinite are left out of this pixel. A point of the layer Position, and its depth, is the mean over the
// renders that meet a surface there; the layers of indices, which do not depend on the samples, are the first one's.
class RenderMerger {
  public:
    // Keeps no reference to `render`. Throws Error, naming the file, if it differs from the others in size, place or
    // channels, if it is another frame of an animation, if it shares a seed with one of them, if it is the same picture
    // as one of them, or if it contains no sample counts.
    void add(const PictureFile& render);

    // The merged picture, with the first file's path, window and metadata; drc:seed lists all seeds, drc:spp is the
    // sum.
    PictureFile merged() const;
    size_t count() const { return paths_.size(); }

  private:
    void requireFit(const PictureFile& render) const;
    void requireSameFrame(const PictureFile& render) const;
    void requireNewSamples(const PictureFile& render);
    void setSurfaceChannels();
    Image sampleCounts(const PictureFile& render) const;
    void addPixel(size_t pixel, const float* values, double samples);

    std::vector<std::string> paths_;
    PictureFile first_;  // its pixels are zero, but for the layers of indices
    std::vector<std::string> seeds_;
    std::set<std::pair<std::string, std::string>> seedsOf_;  // seed, path
    std::set<uint64_t> contents_;
    int64_t spp_ = 0;
    bool allTellSpp_ = true;

    int count_ = -1;             // channel of the sample counts; -1: none
    std::vector<int> beauty_;    // R, G, B
    std::vector<int> variance_;  // channels R, G, B of the variance layer; empty: none
    std::vector<int> surface_;   // channels of the layers Position and Depth, the depth last; empty: there is no depth
    std::vector<int> indices_;   // channels of the layers of indices
    // For each pixel.
    std::vector<double> samples_;       // sum n
    std::vector<double> sums_;          // of each channel, sum n x
    std::vector<double> plainSums_;     // of each channel, sum x: for pixels without samples
    std::vector<double> knownSamples_;  // sum n of the renders with a known variance
    std::vector<double> varianceSums_;  // of R, G, B, sum n^2 var
    std::vector<double> squares_;       // of R, G, B, sum n x^2
    std::vector<int> renders_;          // k
    std::vector<double> metSamples_;    // sum n of the renders that meet a surface
};

}  // namespace drc
