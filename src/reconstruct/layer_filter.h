// Removes noise from the layers of a picture, as far as the layers' own samples show that it is noise.
//
// A layer is averaged along surfaces at several scales. From coarse to fine, each scale adds its detail to the coarser
// ones, reduced to the share that remains when the noise is subtracted; the noise is estimated from independent groups
// of samples (a local Wiener filter: Lee, "Digital Image Enhancement and Noise Filtering by Use of Local Statistics",
// 1980). With more samples this share grows at all scales, down to single pixels, so that the filter fades out as the
// noise does.
#pragma once
#include "reconstruct/lobe_g_buffer.h"
#include "scene/filter.h"

namespace drc {

class LayerFilter {
  public:
    // Groups that a layer's samples are divided into: enough to estimate their noise, and few enough to keep in memory.
    static constexpr int kGroups = int(Filter::kGroups);

    // Filters layers of light that these lobes scatter. Such a layer is demodulated by their albedo while it is
    // averaged, so that textures stay sharp. surfaces must outlive the filter.
    LayerFilter(const LobeGBuffer& surfaces, LobeKind lobes);

    // The mean of the samples, with its noise removed.
    Image smooth(const FilmLayer& samples) const;

    // Corrects, in place, a layer that has little noise but systematic errors (radiance maps are too far apart for the
    // light that they represent; the network is off in hue). Samples of the same light have noise but no such errors;
    // the filtered difference of the two is added. Edge pixels get the difference that is common to the pixels of the
    // edge.
    void correct(Image& layer, const FilmLayer& samples) const;

    // The range of scales that a layer is filtered at: 0 is single pixels, and each further scale is an average twice
    // as wide.
    struct Scales {
        int finest, coarsest;
    };

  private:
    // Whether each pixel that shows a surface has a sample in each group, which the first sample passes do not achieve.
    // If not, the groups' means are taken from averages around a pixel, and no finer detail is shown.
    bool isWhole(const FilmLayer& samples) const;
    struct Filtered {
        Planes values;
        Planes noise;  // one plane: local variance of the mean of a pixel's samples, summed over the channels
    };
    // The samples' mean minus `base` (null: minus nothing), demodulated by albedo, with its noise removed; computed at
    // all pixels, also where it will not be used. whole: the result of isWhole for the samples.
    Filtered withoutNoise(const SurfaceFilter& filter, Scales scales, const FilmLayer& samples, bool whole,
                          const Image* base) const;
    // withoutNoise() without a base, filtered twice: the second filter does not average pixels whose values, after the
    // first, differ by more than noise.
    Planes withoutNoiseBetweenEdges(SurfaceFilter filter, Scales scales, const FilmLayer& samples, bool whole) const;

    // Averages edge pixels with each other, whatever surfaces they show, and to some degree pixels that are nearly edge
    // pixels. An edge pixel mixes two surfaces, so that no neighbour lies on the same surface.
    SurfaceFilter amongEdgePixels() const;

    // column, row: relative to the region.
    Rgb albedo(int column, int row) const {
        const PixelRegion& region = surfaces_.region();
        return surfaces_.albedo(lobes_, region.x0 + column, region.y0 + row);
    }

    const LobeGBuffer& surfaces_;
    LobeKind lobes_;
    SurfaceFilter filter_;
    std::vector<float> trust_;  // how far filter_ is trusted at each pixel: 0 at edge pixels, 1 amid a surface
    SurfaceFilter amongEdgePixels_;
    std::vector<float> trustAmongEdgePixels_;
};

}  // namespace drc
