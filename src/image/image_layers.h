// The layers of a picture with channels named as in OpenEXR: "direct.R" is the channel R of the layer "direct", and "R"
// one of the beauty, whose name is "".
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"

namespace drc {

// The layers of `drc render --aovs` that are not means of samples.
inline constexpr const char* kVarianceLayer = "Denoising Variance";
inline constexpr const char* kSampleCountLayer = "Debug Sample Count";
// The layer that `drc render --noise-threshold` writes.
inline constexpr const char* kErrorLayer = "Estimated Error";

// The part of a channel's name before its last dot, and the part after it.
std::string layerOfChannel(const std::string& channel);
std::string suffixOfChannel(const std::string& channel);

// In the order of their first channels.
std::vector<std::string> layerNames(const Image& image);
// For messages: "the beauty, direct, indirect".
std::string layerList(const Image& image);
// Like layerList(), with the channels of each layer: "the beauty (R, G, B), depth (Z)".
std::string layerAndChannelList(const Image& image);

// The channels of a layer, without its name; nothing if there are none.
std::optional<Image> layerOf(const Image& image, const std::string& layer);
// The channels R, G and B, or else Y, that have no layer's name, and A; the whole image if it has neither.
Image beautyOf(const Image& image);
// Three channels of the layer or channel of that name, linear as the picture is: the layer's R, G and B; without them
// its first three, or its first one thrice; a single channel, "Z" or "depth.Z", thrice. If there is no such layer or
// channel, or the beauty has neither R, G and B nor a Y, throws Error that lists the existing names and suggests the
// nearest.
Image rgbOfLayer(const Image& image, const std::string& layer);
// Sets the channels that rgbOfLayer() gives for a layer, which must be three. Throws Error if they are not.
void setRgbOfLayer(Image& image, const std::string& layer, const Image& rgb);
// The channels of a layer or the channel of that name, under their whole names. Throws Error as rgbOfLayer() does.
Image partOfLayer(const Image& image, const std::string& layer);
// The picture without some of its layers, all of which it need not have. Throws Error if nothing is left.
Image withoutLayers(const Image& image, const std::vector<std::string>& layers);

}  // namespace drc
