#include "view/tev_picture.h"

#include <algorithm>

#include "image/premultiply.h"

namespace drc::tev {
namespace {

// The side of a tile, pixels. A tile of three channels has 200 KB: small compared with the buffers of a network, large
// compared with the names that are sent with each tile.
constexpr int kTile = 128;

}  // namespace

Picture pictureOf(LayeredPicture picture, const FilmGeometry& film) {
    Picture result{{}, picture.film->region(), film};
    std::vector<Picture::Layer>& layers = result.layers;
    if (picture.hasParts())
        for (const char* part : {"direct", "indirect"}) layers.push_back({part, picture.part(part)});
    if (picture.samples) {
        layers.push_back({"variance", picture.variance()});
        layers.push_back({"samples", std::move(*picture.samples)});
    }
    if (picture.gBuffer) {
        layers.push_back({"albedo", std::move(picture.gBuffer->albedo)});
        layers.push_back({"normal", std::move(picture.gBuffer->normal)});
        layers.push_back({"depth", std::move(picture.gBuffer->depth)});
    }
    if (picture.alpha) picture.beauty = withAlpha(picture.beauty, *picture.alpha);
    layers.insert(layers.begin(), {"", std::move(picture.beauty)});
    return result;
}

Picture pictureOf(Preview preview, const PixelRegion& region, const FilmGeometry& film) {
    if (preview.alpha) preview.beauty = withAlpha(preview.beauty, *preview.alpha);
    return {{{"", std::move(preview.beauty)}, {"samples", std::move(preview.samples)}}, region, film};
}

std::vector<std::string> channelNames(const Picture& picture) {
    std::vector<std::string> names;
    for (const Picture::Layer& layer : picture.layers)
        for (std::string& name : channelNames(layer)) names.push_back(std::move(name));
    return names;
}

std::vector<std::string> channelNames(const Picture::Layer& layer) {
    std::vector<std::string> names;
    for (const std::string& channel : layer.image.channelNames())
        names.push_back(layer.name.empty() ? channel : layer.name + "." + channel);
    return names;
}

std::vector<PixelRegion> tilesOf(const PixelRegion& region) {
    std::vector<PixelRegion> tiles;
    for (int y = region.y0; y < region.y1; y += kTile)
        for (int x = region.x0; x < region.x1; x += kTile)
            tiles.push_back({x, y, std::min(x + kTile, region.x1), std::min(y + kTile, region.y1)});
    return tiles;
}

std::vector<float> valuesOf(const Picture& picture, const Picture::Layer& layer, const PixelRegion& tile) {
    const size_t inRow = size_t(tile.width()) * size_t(layer.image.channels());
    std::vector<float> values(inRow * size_t(tile.height()));
    float* to = values.data();
    for (int y = tile.y0; y < tile.y1; ++y, to += inRow)
        std::copy_n(layer.image.pixel(tile.x0 - picture.region.x0, y - picture.region.y0), inRow, to);
    return values;
}

}  // namespace drc::tev
