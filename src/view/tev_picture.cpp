#include "view/tev_picture.h"

#include <algorithm>

#include "image/premultiply.h"

namespace drc::tev {
namespace {

// The side of a tile, pixels. A tile of twenty channels has 1.3 MB: small beside what a network holds on its way, large
// beside the names that go with each.
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

std::vector<std::string> channelNames(const Picture& picture) {
    std::vector<std::string> names;
    for (const auto& [layer, image] : picture.layers)
        for (const std::string& channel : image.channelNames())
            names.push_back(layer.empty() ? channel : layer + "." + channel);
    return names;
}

std::vector<PixelRegion> tilesOf(const PixelRegion& region) {
    std::vector<PixelRegion> tiles;
    for (int y = region.y0; y < region.y1; y += kTile)
        for (int x = region.x0; x < region.x1; x += kTile)
            tiles.push_back({x, y, std::min(x + kTile, region.x1), std::min(y + kTile, region.y1)});
    return tiles;
}

std::vector<float> valuesOf(const Picture& picture, const PixelRegion& tile) {
    size_t channels = 0;
    for (const auto& layer : picture.layers) channels += size_t(layer.image.channels());
    std::vector<float> values(tile.count() * channels);
    size_t first = 0;
    for (const auto& [name, image] : picture.layers) {
        float* to = values.data() + first;
        for (int y = tile.y0; y < tile.y1; ++y) {
            const float* from = image.pixel(tile.x0 - picture.region.x0, y - picture.region.y0);
            for (int x = tile.x0; x < tile.x1; ++x, from += image.channels(), to += channels)
                std::copy_n(from, image.channels(), to);
        }
        first += size_t(image.channels());
    }
    return values;
}

}  // namespace drc::tev
