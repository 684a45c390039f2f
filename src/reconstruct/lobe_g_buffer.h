// The G-buffer that guides the filters of layers of light: for each kind of lobes, their albedo and the surface that
// has them, from the same camera samples as the light itself.
#pragma once
#include <array>

#include "film/film.h"
#include "reconstruct/surface_filter.h"
#include "transport/path_tracer.h"

namespace drc {

// The non-specular lobes whose light a layer contains: all, only the broad ones or only the glossy ones (LobeMask).
enum class LobeKind { All, Broad, Glossy };

class LobeGBuffer {
  public:
    // Adds the layers of this G-buffer to those of a film. extent: of the scene, world units; sets the resolution of
    // positions.
    static void addSpecs(std::vector<FilmLayerSpec>& layers, float extent);
    // Adds a sample. looked: false if the lens blocked all light of the sample, which then darkens the pixel but says
    // nothing about its surface. firstLayer: index of the first of the layers that addSpecs added.
    static void add(Film& film, size_t firstLayer, int x, int y, const SampleLayers& sample, float filterWeight,
                    bool looked);

    // Reads the G-buffer of a film that has these layers and must outlive it.
    explicit LobeGBuffer(const Film& film);

    // A filter along the surfaces that have these lobes. In an edge pixel, surfaces are weighted by their albedo: a
    // pixel half covered by a lamp, the sky or a black surface is filtered like its other half.
    SurfaceFilter filter(LobeKind lobes) const;
    // The pixel's mean albedo of these lobes: the share of light that they scatter.
    Rgb albedo(LobeKind lobes, int x, int y) const { return albedo_[size_t(lobes)]->mean(x, y); }
    const PixelRegion& region() const { return albedo_[0]->region(); }

  private:
    // Indexed by LobeKind. surface_ contains sums over samples. Each sample's weight is the luminance of its albedo
    // times the absolute weight of the pixel filter; the sums are of this weight and of the weighted position, normal,
    // and width of a pixel on the surface.
    std::array<const FilmLayer*, 3> albedo_, surface_;
};

}  // namespace drc
