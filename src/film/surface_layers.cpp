#include "film/surface_layers.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "image/image_layers.h"
#include "transport/seen_surface.h"

namespace drc {
namespace {

// The mean of the points in a pixel, in the scene's world space; none if no sample has met a surface.
std::optional<Vec3> meanPoint(const FilmLayer& layer, int x, int y) {
    const double count = layer.expected(x, y);
    if (count == 0) return {};
    const auto mean = [&](int channel) { return float(layer.sum(x, y, channel) / count); };
    return Vec3(mean(0), mean(1), mean(2));
}

}  // namespace

void addMetSpec(std::vector<FilmLayerSpec>& layers, float extent) {
    // The scene lies within a few of its radii from zero. The sums resolve a billionth of a radius, and saturate after
    // billions of samples.
    const double radius = std::isfinite(extent) ? std::max(1e-30, double(extent)) : 1;
    layers.push_back({.name = kMetLayer, .quantum = std::exp2(std::ceil(std::log2(radius)) - 30)});
}

void addMet(FilmLayer& layer, int x, int y, const GBufferSample& sample) {
    // Without the weights of the pixel filter, which may be negative, the mean lies between the points.
    if (sample.meets && isFinite(sample.position)) layer.add(x, y, 0, sample.position, 1);
}

SurfaceLayers surfaceLayersOf(const Film& film, const Scene& scene, const Accel& accel, const Camera& camera) {
    const PixelRegion& region = film.region();
    const FilmLayer& met = film.layer(kMetLayer);
    const int width = region.width(), height = region.height();
    const Transform toCamera = camera.worldToCameraAt(0);
    SurfaceLayers layers{Image(width, height, {"X", "Y", "Z"}), Image(width, height, {"Z"}),
                         Image(width, height, {"X"}), Image(width, height, {"X"})};
    const auto setPixel = [&](int column, int row) {
        const int x = region.x0 + column, y = region.y0 + row;
        float& depth = layers.depth.at(column, row, 0) = kNoDepth;
        if (const std::optional<Vec3> p = meanPoint(met, x, y)) {
            layers.position.setRgb(column, row, *p + scene.origin);
            const Vec3 inCamera = toCamera.point(*p);
            depth = camera.isPanoramic() ? length(inCamera) : inCamera.z;
        }
        if (const auto seen = seenSurface(accel, camera, Vec2(float(x) + 0.5f, float(y) + 0.5f))) {
            const uint32_t ofInstance = seen->instance ? seen->instance->objectNumber : 0;
            layers.object.at(column, row, 0) = float(ofInstance > 0 ? ofInstance : seen->primitive->objectNumber);
            layers.material.at(column, row, 0) = float(seen->primitive->materialNumber);
        }
    };
    parallelFor(0, height, 8, [&](int begin, int end) {
        for (int row = begin; row < end; ++row)
            for (int column = 0; column < width; ++column) setPixel(column, row);
    });
    return layers;
}

}  // namespace drc
