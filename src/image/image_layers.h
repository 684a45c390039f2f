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
// Of `drc render --noise-threshold`.
inline constexpr const char* kErrorLayer = "Estimated Error";

// The part of a channel's name before its last dot, and the part after it.
std::string layerOfChannel(const std::string& channel);
std::string suffixOfChannel(const std::string& channel);

// In the order of their first channels.
std::vector<std::string> layerNames(const Image& image);
// For messages: "the beauty, direct, indirect".
std::string layerList(const Image& image);

// The channels of a layer, without its name; nothing if there are none.
std::optional<Image> layerOf(const Image& image, const std::string& layer);
// Three channels, linear as the picture is: the channels R, G and B of a layer or, of another layer, its first three
// or its only one. Throws Error if there is no such layer or, for the beauty, if it has neither R, G and B nor a Y.
Image rgbOfLayer(const Image& image, const std::string& layer);
// Sets the channels that rgbOfLayer() gives, which must be three. Throws Error if they are not.
void setRgbOfLayer(Image& image, const std::string& layer, const Image& rgb);
// The picture without some of its layers, all of which it need not have. Throws Error if nothing is left.
Image withoutLayers(const Image& image, const std::vector<std::string>& layers);

}  // namespace drc
