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
// Layers of `drc render --aovs` for compositing and for filters over time, of the surfaces that the camera itself sees.
inline constexpr const char* kPositionLayer = "Position";           // X, Y, Z: mean, in the scene file's world space
inline constexpr const char* kDepthLayer = "Depth";                 // Z: of Position, along the camera's axis
inline constexpr const char* kObjectIndexLayer = "IndexOB";         // X: at the pixel's centre; 0: nothing
inline constexpr const char* kMaterialIndexLayer = "IndexMA";       // X: at the pixel's centre; 0: nothing
inline constexpr const char* kVectorLayer = "Vector";               // X, Y, Z, W: motionVectors()
inline constexpr const char* kHalfLayers[] = {"Half A", "Half B"};  // two independent halves of the samples
inline constexpr const char* kDirectHalfLayers[] = {"direct Half A", "direct Half B"};
// In the layer Depth, where the camera sees no surface.
inline constexpr float kNoDepth = 1e10f;
// The layer that `drc render --noise-threshold` writes.
inline constexpr const char* kErrorLayer = "Estimated Error";

// The part of a channel's name before its last dot, and the part after it.
std::string layerOfChannel(const std::string& channel);
std::string suffixOfChannel(const std::string& channel);

// The names of all layers, in the order of their first channels.
std::vector<std::string> layerNames(const Image& image);
// For messages: "the beauty, direct, indirect".
std::string layerList(const Image& image);
// Like layerList(), with the channels of each layer: "the beauty (R, G, B), depth (Z)".
std::string layerAndChannelList(const Image& image);

// The channels of a layer, named without the layer's name; empty if there are none.
std::optional<Image> layerOf(const Image& image, const std::string& layer);
// The channels "R", "G" and "B" or else "Y", and "A" if there is one; the whole image if it has neither colours nor
// "Y".
Image beautyOf(const Image& image);
// The layer or channel of this name as an image R, G, B with unchanged values: the layer's R, G and B; without them its
// first three channels, or its first one thrice; a single channel ("Z" or "depth.Z") thrice. Throws Error, which lists
// the existing names and suggests the nearest, if there is no such layer or channel, or if the beauty has neither R, G
// and B nor a Y.
Image rgbOfLayer(const Image& image, const std::string& layer);
// Sets the three channels that rgbOfLayer() reads for a layer. Throws Error if it reads a single one.
void setRgbOfLayer(Image& image, const std::string& layer, const Image& rgb);
// The channels of a layer, or the channel of this name, under their full names. Throws Error as rgbOfLayer() does.
Image partOfLayer(const Image& image, const std::string& layer);
// The picture without the given layers; those that it does not have are ignored. Throws Error if nothing is left.
Image withoutLayers(const Image& image, const std::vector<std::string>& layers);

}  // namespace drc
