#include "reconstruct/lobe_g_buffer.h"

namespace drc {
namespace {

constexpr const char* kAlbedo[] = {"albedo", "broad-albedo", "glossy-albedo"};
constexpr const char* kSurface[] = {"surface", "broad-surface", "glossy-surface"};
enum SurfaceChannel { kShare, kPosition, kNormal = kPosition + 3, kPixelSize = kNormal + 3, kSurfaceChannels };

}  // namespace

void LobeGBuffer::addSpecs(std::vector<FilmLayerSpec>& layers, float extent) {
    // The quantum resolves micrometres in a scene a kilometre wide.
    const double quantum = std::exp2(std::round(std::log2(std::max(1e-30, double(extent)))) - 30);
    for (size_t i = 0; i < 3; ++i) {
        layers.push_back({.name = kAlbedo[i], .storage = FilmLayerSpec::Storage::Single});
        layers.push_back({.name = kSurface[i],
                          .channels = kSurfaceChannels,
                          .weighted = false,
                          .quantum = std::min(quantum, 0x1p-24)});
    }
}

void LobeGBuffer::add(Film& film, size_t firstLayer, int x, int y, const SampleLayers& sample, float filterWeight,
                      bool looked) {
    const Rgb albedos[] = {sample.albedo, sample.broadAlbedo, sample.glossyAlbedo};
    const Vec3 &p = sample.position, &n = sample.normal;
    for (size_t i = 0; i < 3; ++i) {
        film.layer(firstLayer + 2 * i).add(x, y, 0, albedos[i], filterWeight);
        // The absolute value, because negative filter weights must not count against a surface.
        const float share = luminance(albedos[i]) * std::abs(filterWeight);
        if (!looked || !(share > 0)) continue;
        const float values[] = {1, p.x, p.y, p.z, n.x, n.y, n.z, sample.pixelSize};
        film.layer(firstLayer + 2 * i + 1).add(x, y, 0, values, share);
    }
}

LobeGBuffer::LobeGBuffer(const Film& film) {
    for (size_t i = 0; i < 3; ++i) {
        albedo_[i] = &film.layer(kAlbedo[i]);
        surface_[i] = &film.layer(kSurface[i]);
    }
}

SurfaceFilter LobeGBuffer::filter(LobeKind lobes) const {
    SurfaceFilter filter(region().width(), region().height());
    const FilmLayer& sums = *surface_[size_t(lobes)];
    for (int y = region().y0; y < region().y1; ++y)
        for (int x = region().x0; x < region().x1; ++x) {
            const double share = sums.sum(x, y, kShare);
            if (!(share > 0)) continue;
            const auto mean = [&](int channel) { return float(sums.sum(x, y, channel) / share); };
            filter.show(region().index(x, y), Vec3(mean(kPosition), mean(kPosition + 1), mean(kPosition + 2)),
                        normalize(Vec3(mean(kNormal), mean(kNormal + 1), mean(kNormal + 2))), mean(kPixelSize));
        }
    return filter;
}

}  // namespace drc
