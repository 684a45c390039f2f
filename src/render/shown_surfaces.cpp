#include "render/shown_surfaces.h"

namespace drc {

void ShownSurfaces::add(int x, int y, const SampleLayers& sample, float filterWeight, bool looked) {
    const Rgb albedos[] = {sample.albedo, sample.wideAlbedo, sample.narrowAlbedo};
    for (size_t i = 0; i < albedo_.size(); ++i) {
        albedo_[i].add(x, y, albedos[i], filterWeight);
        if (!looked) continue;
        Geometry& g = geometry_[region().index(x, y)][i];
        // Negative lobes of the filter have no say in which surface it is.
        const float share = luminance(albedos[i]) * std::abs(filterWeight);
        g.share += share;
        g.pixelSize += share * sample.pixelSize;
        for (int c = 0; c < 3; ++c) {
            g.position[c] += double(share) * sample.position[c];
            g.normal[c] += share * sample.normal[c];
        }
    }
}

SurfaceFilter ShownSurfaces::filter(Scattering lobes) const {
    SurfaceFilter filter(region().width(), region().height());
    for (size_t i = 0; i < geometry_.size(); ++i) {
        const Geometry& g = geometry_[i][size_t(lobes)];
        if (!(g.share > 0)) continue;
        const Vec3 position(float(g.position[0] / g.share), float(g.position[1] / g.share),
                            float(g.position[2] / g.share));
        filter.show(i, position, normalize(Vec3(g.normal[0], g.normal[1], g.normal[2])), float(g.pixelSize / g.share));
    }
    return filter;
}

}  // namespace drc
