// What surface each pixel shows, by the samples of direct light: filters must not mix different ones.
#pragma once
#include <array>

#include "integrators/path_tracer.h"
#include "render/film.h"
#include "render/surface_filter.h"

namespace drc {

// Which of the surfaces' lobes a layer is of: all but the specular ones, and of these the wide or the narrow ones.
enum class Scattering { All, Wide, Narrow };

class ShownSurfaces {
  public:
    ShownSurfaces() = default;
    explicit ShownSurfaces(const PixelRegion& region) : geometry_(region.count()) { albedo_.fill(FilmLayer(region)); }

    // looked: false if the camera let nothing of the sample through, which darkens the pixel, but says nothing of the
    // surface that it shows.
    void add(int x, int y, const SampleLayers& sample, float filterWeight, bool looked);

    // By the surfaces that scatter with these lobes. In a pixel at an edge each counts by its albedo: one half of which
    // is a lamp, the sky or a black surface shows the other half.
    SurfaceFilter filter(Scattering lobes) const;
    // Share of light that the pixel's surface scatters with these lobes.
    Rgb albedo(Scattering lobes, int x, int y) const { return albedo_[size_t(lobes)].value(x, y); }
    const PixelRegion& region() const { return albedo_[0].region(); }

  private:
    // Sums over samples, each by `share`: the luminance of its albedo, times the pixel filter's weight.
    struct Geometry {
        double share = 0, position[3] = {0, 0, 0};
        float normal[3] = {0, 0, 0}, pixelSize = 0;
    };
    // By Scattering.
    std::array<FilmLayer, 3> albedo_;
    std::vector<std::array<Geometry, 3>> geometry_;
};

}  // namespace drc
