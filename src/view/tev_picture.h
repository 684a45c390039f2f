// A picture in the form that tev gets: layers as channels of one image of the film's size, which is sent in tiles.
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

// The layers of the picture, as far as it has them: beauty, direct, indirect, albedo, normal, depth, variance, samples.
Picture pictureOf(LayeredPicture picture, const FilmGeometry& film);
// The beauty and the samples only.
Picture pictureOf(Preview preview, const PixelRegion& region, const FilmGeometry& film);

// Channel names of all layers, or of one: "R", "G", "B", "direct.R" and so on.
std::vector<std::string> channelNames(const Picture& picture);
std::vector<std::string> channelNames(const Picture::Layer& layer);
// Tiles that cover the region: squares of 128 pixels, cut off at the right and at the bottom edge.
std::vector<PixelRegion> tilesOf(const PixelRegion& region);
// The values of a tile of the region in one of the picture's layers, row by row, with the channels of each pixel
// together.
std::vector<float> valuesOf(const Picture& picture, const Picture::Layer& layer, const PixelRegion& tile);

}  // namespace drc::tev
