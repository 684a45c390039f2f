// The G-buffer that guides the filters of layers of light: for each kind of lobes their albedo and the surface that
// scatters with them, from the same camera samples as the light itself.
#pragma once
#include <array>

#include "film/film.h"
#include "reconstruct/surface_filter.h"
#include "transport/path_tracer.h"

namespace drc {

// The lobes whose light a layer holds: all non-specular ones, or of these the broad or the glossy ones (LobeMask).
enum class LobeKind { All, Broad, Glossy };

class LobeGBuffer {
  public:
    // Adds the film's layers of this G-buffer. extent: of the scene, in world units; it sets the resolution of
    // positions.
    static void addSpecs(std::vector<FilmLayerSpec>& layers, float extent);
    // Adds a sample. looked: false if the camera let nothing of the sample through, which darkens the pixel but says
    // nothing about the surface in it. firstLayer: index of the first of the layers that addSpecs added.
    static void add(Film& film, size_t firstLayer, int x, int y, const SampleLayers& sample, float filterWeight,
                    bool looked);

    // Reads the G-buffer of a film that has these layers and must outlive it.
    explicit LobeGBuffer(const Film& film);

    // A filter along the surfaces that scatter with these lobes. In an edge pixel each surface counts by its albedo: a
    // pixel half covered by a lamp, the sky or a black surface shows its other half.
    SurfaceFilter filter(LobeKind lobes) const;
    // The share of light that the pixel's surfaces scatter with these lobes.
    Rgb albedo(LobeKind lobes, int x, int y) const { return albedo_[size_t(lobes)]->mean(x, y); }
    const PixelRegion& region() const { return albedo_[0]->region(); }

  private:
    // By LobeKind. surface_ has sums over samples, each weighted by the luminance of its albedo times the pixel
    // filter's weight: the sum of these weights, position, normal, and the width of a pixel on the surface.
    std::array<const FilmLayer*, 3> albedo_, surface_;
};

}  // namespace drc
