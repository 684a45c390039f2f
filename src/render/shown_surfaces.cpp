#include "render/shown_surfaces.h"

namespace drc {
void ShownSurfaces::add(int x, int y, const SampleLayers& sample, float filterWeight, bool looked) {
    albedo_.add(x, y, sample.albedo, filterWeight);
    wideAlbedo_.add(x, y, sample.wideAlbedo, filterWeight);
    narrowAlbedo_.add(x, y, sample.narrowAlbedo, filterWeight);
    if (!looked) return;
    normal_.add(x, y, Rgb(sample.normal.x, sample.normal.y, sample.normal.z), filterWeight);
    position_.add(x, y, Rgb(sample.position.x, sample.position.y, sample.position.z), filterWeight);
    size_.add(x, y, Rgb(sample.pixelSize), filterWeight);
}

SurfaceFilter ShownSurfaces::filter() const {
    const PixelRegion& region = normal_.region();
    SurfaceFilter filter(region.width(), region.height());
    for (int y = region.y0; y < region.y1; ++y)
        for (int x = region.x0; x < region.x1; ++x) {
            const Rgb p = position_.value(x, y), n = normal_.value(x, y);
            filter.show(region.index(x, y), Vec3(p.x, p.y, p.z), normalize(Vec3(n.x, n.y, n.z)), size_.value(x, y).x);
        }
    return filter;
}

}  // namespace drc
