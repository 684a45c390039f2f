// What surface each pixel shows, by the samples of direct light: filters must not mix different ones.
#pragma once
#include "integrators/path_tracer.h"
#include "render/film.h"
#include "render/surface_filter.h"

namespace drc {

class ShownSurfaces {
  public:
    ShownSurfaces() = default;
    explicit ShownSurfaces(const PixelRegion& region)
        : normal_(region),
          position_(region),
          size_(region),
          albedo_(region),
          wideAlbedo_(region),
          narrowAlbedo_(region) {}

    // looked: false if the camera let nothing of the sample through, which darkens the pixel, but says nothing of the
    // surface that it shows.
    void add(int x, int y, const SampleLayers& sample, float filterWeight, bool looked);

    SurfaceFilter filter() const;
    // Share of light that the pixel's surface scatters: by all but its specular lobes, by the wide and by the narrow
    // ones.
    Rgb albedo(int x, int y) const { return albedo_.value(x, y); }
    Rgb wideAlbedo(int x, int y) const { return wideAlbedo_.value(x, y); }
    Rgb narrowAlbedo(int x, int y) const { return narrowAlbedo_.value(x, y); }
    const PixelRegion& region() const { return normal_.region(); }

  private:
    FilmLayer normal_, position_, size_, albedo_, wideAlbedo_, narrowAlbedo_;
};

}  // namespace drc
