// Removes noise from layers of a picture, as far as their samples tell it from what is there.
//
// A layer is averaged along surfaces at several scales. From coarse to fine, of what each scale adds to the coarser
// ones only that share is kept that the samples' own noise, estimated from independent groups of them, leaves (a local
// Wiener filter: Lee, "Digital Image Enhancement and Noise Filtering by Use of Local Statistics", 1980). With ever more
// samples that is all, down to single pixels: the filter goes away as the noise does.
#pragma once
#include "render/lobe_g_buffer.h"

namespace drc {

class LayerFilter {
  public:
    // Of a layer's samples: enough to tell their noise by, and few enough to keep.
    static constexpr int kGroups = 4;

    // Of layers of light that these lobes scatter. While it is averaged such a layer is divided by their albedo, so
    // that textures stay sharp. surfaces must outlive the filter.
    LayerFilter(const LobeGBuffer& surfaces, LobeKind lobes);

    // The samples' mean without noise.
    Image smooth(const FilmLayer& samples) const;

    // Corrects a layer that has little noise but errors of its own (radiance maps stand too far apart for what they
    // light; the network is off in hue) by samples of the same light that have noise but no such error: adds the
    // filtered difference of the two, in place. Pixels that show an edge are corrected by that of the edge's others.
    void correct(Image& layer, const FilmLayer& samples) const;

    // Of what a layer is looked at in: 0, single pixels; each further one an average twice as wide.
    struct Scales {
        int finest, coarsest;
    };

  private:
    // Whether each pixel that shows a surface has a sample in each group. Where not, as in the first sweeps, groups are
    // known from the pixels about, and there is nothing finer than these.
    bool isWhole(const FilmLayer& samples) const;
    struct Filtered {
        Planes values;
        Planes noise;  // one plane: variance of the mean of a pixel's own samples thereabouts, summed over the channels
    };
    // What is left of the samples' mean minus `base` (null: minus nothing), divided by albedo; also where that is of no
    // use. whole: what isWhole says of the samples.
    Filtered withoutNoise(const SurfaceFilter& filter, Scales scales, const FilmLayer& samples, bool whole,
                          const Image* base) const;
    // Without a base, and without averaging what differs by more than noise, which a first filter without that
    // condition tells.
    Planes withoutNoiseBetweenEdges(SurfaceFilter filter, Scales scales, const FilmLayer& samples, bool whole) const;

    // Averages strays, and what is one in part, with each other, whatever they show. Strays are pixels that stand
    // alone, as those that mix two surfaces at an edge.
    SurfaceFilter amongStrays() const;

    // By pixels of the region.
    Rgb albedo(int column, int row) const {
        const PixelRegion& region = surfaces_.region();
        return surfaces_.albedo(lobes_, region.x0 + column, region.y0 + row);
    }

    const LobeGBuffer& surfaces_;
    LobeKind lobes_;
    SurfaceFilter filter_;
    std::vector<float> trust_;  // of the filter at each pixel, from 0 (it stands alone) to 1
    SurfaceFilter amongStrays_;
    std::vector<float> trustAmongStrays_;
};

}  // namespace drc
