// The G-buffer that layers of light are filtered by: for each kind of lobes, their albedo and the surface that scatters
// with them, by the same camera samples as the light itself.
#pragma once
#include <array>

#include "integrators/path_tracer.h"
#include "render/film.h"
#include "render/surface_filter.h"

namespace drc {

// Which of the surfaces' lobes a layer is of: all but the specular ones, and of these the broad or the glossy ones.
enum class LobeKind { All, Broad, Glossy };

class LobeGBuffer {
  public:
    // The film's layers of it. extent: of the scene, world units, which sets the resolution of positions.
    static void addSpecs(std::vector<FilmLayerSpec>& layers, float extent);
    // looked: false if the camera let nothing of the sample through, which darkens the pixel, but says nothing of the
    // surface that it shows. firstLayer: the index of the first of the film's layers of it.
    static void add(Film& film, size_t firstLayer, int x, int y, const SampleLayers& sample, float filterWeight,
                    bool looked);

    // Of a film that has them, which must outlive this.
    explicit LobeGBuffer(const Film& film);

    // By the surfaces that scatter with these lobes. In a pixel at an edge each counts by its albedo: one half of which
    // is a lamp, the sky or a black surface shows the other half.
    SurfaceFilter filter(LobeKind lobes) const;
    // Share of light that the pixel's surface scatters with these lobes.
    Rgb albedo(LobeKind lobes, int x, int y) const { return albedo_[size_t(lobes)]->mean(x, y); }
    const PixelRegion& region() const { return albedo_[0]->region(); }

  private:
    // By LobeKind. Of surfaces, sums over samples, each by the luminance of its albedo times the pixel filter's weight:
    // of that itself, position, normal and the width of a pixel there.
    std::array<const FilmLayer*, 3> albedo_, surface_;
};

}  // namespace drc
