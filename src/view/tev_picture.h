// A picture as tev is shown it: layers as channels of one image of the film's size, which goes over in tiles.
#pragma once
#include <string>
#include <vector>

#include "film/layered_picture.h"
#include "film/preview.h"

namespace drc::tev {

struct Picture {
    struct Layer {
        std::string name;  // empty: the beauty
        Image image;
    };
    std::vector<Layer> layers;  // all of the region's size
    PixelRegion region;         // of the film, in pixels
    FilmGeometry film;
};

// The layers that the picture has of: the beauty, direct, indirect, albedo, normal, depth, variance, samples.
Picture pictureOf(LayeredPicture picture, const FilmGeometry& film);
// The beauty and the samples alone.
Picture pictureOf(Preview preview, const PixelRegion& region, const FilmGeometry& film);

// "R", "G", "B", "direct.R" and so on: of all layers, or of one.
std::vector<std::string> channelNames(const Picture& picture);
std::vector<std::string> channelNames(const Picture::Layer& layer);
// Squares of 128 pixels, or what is left of them at the right and at the bottom, that cover the region.
std::vector<PixelRegion> tilesOf(const PixelRegion& region);
// The values of a tile of the region in one of the picture's layers, those of all channels of a pixel together, row by
// row.
std::vector<float> valuesOf(const Picture& picture, const Picture::Layer& layer, const PixelRegion& tile);

}  // namespace drc::tev
