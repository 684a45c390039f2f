#include "image/frame_surfaces.h"

#include <fmt/core.h>

#include "base/error.h"
#include "image/image_layers.h"

namespace drc {

Image layerOverTime(const PictureFile& picture, const std::string& layer) {
    std::optional<Image> image = layerOf(picture.image, layer);
    if (!image)
        throw Error(
            fmt::format("{}: it has no layer '{}', which is needed to follow surfaces over time; render it with "
                        "--aovs and an integrator that has this layer, such as drc or path",
                        picture.path, layer));
    clearNonFinite(*image);
    return std::move(*image);
}

FrameSurfaces frameSurfacesOf(const PictureFile& picture) {
    const std::optional<FrameGeometry> geometry = frameGeometryIn(picture);
    if (!geometry || !geometry->worldToNdc)
        throw Error(
            fmt::format("{}: it does not have its camera's matrix {}, which is needed to follow surfaces over "
                        "time; drc render --aovs writes it for perspective and orthographic cameras",
                        picture.path, kWorldToNdc));
    FrameSurfaces surfaces;
    surfaces.name = picture.path;
    surfaces.window = picture.window;
    surfaces.geometry = *geometry;
    surfaces.albedo = layerOverTime(picture, "Denoising Albedo");
    surfaces.normal = layerOverTime(picture, "Denoising Normal");
    surfaces.position = layerOverTime(picture, kPositionLayer);
    surfaces.depth = layerOverTime(picture, kDepthLayer);
    surfaces.object = layerOverTime(picture, kObjectIndexLayer);
    return surfaces;
}

}  // namespace drc
