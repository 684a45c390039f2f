// The U-Net's architecture, on which renderer, trainer and weights file must agree.
// Encoder level l works at size/2^l with width*2^l channels: a block, then 2x2 max pooling except on the last level.
// Each decoder level upsamples bilinearly by 2, concatenates the result of the encoder level of the same size (these
// skip channels come first) and applies a block. The last layer is a 1x1 convolution with a ReLU. All other activations
// are LeakyReLU 0.2. Kinds of block:
//   Plain      two 3x3 convolutions
//   Residual   as Plain, with a 1x1 convolution of the block's input added before the last activation
//   Separable  1x1, and then twice: depthwise 3x3, 1x1
//   Paper      as in the authors' program: two 3x3 convolutions, batch normalisation after the first one's
//              activation (not at full size); the last level's and each decoder's second convolution halve the channels
// Only Paper normalises; its exported weights contain a scale and a shift per channel.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "neural/safetensors.h"
#include "neural/transforms.h"

namespace drc {

inline constexpr float kLeakySlope = 0.2f;

// A convolution. Its tensors are name + ".weight" [out][in][kernel][kernel] ([out][1][kernel][kernel] if depthwise),
// name + ".bias" [out] and, if affine, name + ".scale" and name + ".shift" [out].
struct ConvShape {
    std::string name;
    int in = 0, out = 0, kernel = 3;
    bool depthwise = false;  // one filter per channel; in == out
    bool affine = false;     // multiplies by scale and adds shift after the activation

    int inputsPerFilter() const { return depthwise ? 1 : in; }
    size_t weightCount() const { return size_t(out) * inputsPerFilter() * kernel * kernel; }
    size_t parameterCount() const { return weightCount() + size_t(out) * (affine ? 3 : 1); }
};

enum class LayerOp { Conv, MaxPool, Upsample };

// One layer. Values are numbered: value 0 is the network's input, value i the result of layer i - 1.
struct Layer {
    LayerOp op = LayerOp::Conv;
    int source = 0;
    int size = 0;  // width and height of the result
    // For convolutions only:
    ConvShape conv{};
    int skip = -1;    // value concatenated in front of source; -1: none
    int add = -1;     // value added before the activation, which no later layer reads; -1: none
    float slope = 1;  // slope of the activation max(x, slope x); 1 is none

    // Variance of random weights for which the results have the variance of the inputs (He et al., "Delving Deep into
    // Rectifiers", 2015). Where two results are added, each contributes half.
    double initialVariance() const {
        const double gain = 2 / (1 + double(slope) * slope) * (add >= 0 ? 0.5 : 1);
        return gain / (double(conv.inputsPerFilter()) * conv.kernel * conv.kernel);
    }
};

enum class UNetKind { Plain, Residual, Separable, Paper };
inline constexpr UNetKind kUNetKinds[] = {UNetKind::Plain, UNetKind::Residual, UNetKind::Separable, UNetKind::Paper};
// The name of a kind, such as "plain", and the kind of a name; throws drc::Error for an unknown name.
std::string unetKindName(UNetKind kind);
UNetKind parseUNetKind(const std::string& name);

struct UNetShape {
    UNetKind kind = UNetKind::Plain;
    int width = 32;
    int levels = 4;
    int size = 32;
    int inputs = kPlainPlanes;  // number of input planes: kPlainPlanes or kGuidedPlanes
    int outputs = kOutputPlanes;

    int channels(int level) const { return width << level; }
    int sizeAt(int level) const { return size >> level; }
    // The layers in order of evaluation; the result of the last one is the output.
    std::vector<Layer> layers() const;
    // The convolutions of layers().
    std::vector<ConvShape> convs() const;
    size_t parameterCount() const;
    // Number of multiply-adds per map.
    double macs() const;
    bool operator==(const UNetShape&) const = default;

    // The metadata keys "architecture", "width", "levels", "size", "inputs".
    StringMap toMetadata() const;
    // Throws drc::Error (one line, with the file name) if "architecture" or "width" is missing or a value is not
    // supported. The other keys have defaults.
    static UNetShape fromMetadata(const SafetensorsFile& file);
};

}  // namespace drc
