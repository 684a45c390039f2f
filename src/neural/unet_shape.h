// The U-Net's architecture, on which renderer, trainer and weights file must agree.
// Encoder level l works at size/2^l with width*2^l channels: a block, then 2x2 max pooling except on the last level.
// Each decoder level upsamples bilinearly by 2, concatenates the encoder's result of its level (skip channels first)
// and applies a block. A 1x1 convolution and a ReLU come last. All other activations are LeakyReLU 0.2. A block is:
//   Plain      two 3x3 convolutions
//   Residual   the same, and a 1x1 convolution of the block's input added before the last activation
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

// One layer. Values are numbered: 0 is the network's input, i the result of layer i - 1.
struct Layer {
    LayerOp op = LayerOp::Conv;
    int source = 0;
    int size = 0;  // width and height of the result
    // For convolutions only:
    ConvShape conv{};
    int skip = -1;    // value that is concatenated in front of source
    int add = -1;     // value that is added before the activation; no later layer reads it
    float slope = 1;  // of the activation max(x, slope x); 1 is none

    // Variance of random weights for which results vary as much as inputs (He et al., "Delving Deep into Rectifiers",
    // 2015). Where two results are added, each contributes half.
    double initialVariance() const {
        const double gain = 2 / (1 + double(slope) * slope) * (add >= 0 ? 0.5 : 1);
        return gain / (double(conv.inputsPerFilter()) * conv.kernel * conv.kernel);
    }
};

enum class UNetKind { Plain, Residual, Separable, Paper };
inline constexpr UNetKind kUNetKinds[] = {UNetKind::Plain, UNetKind::Residual, UNetKind::Separable, UNetKind::Paper};
// "plain" and so on; throws drc::Error for any other name.
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
    // In order of evaluation. The result of the last layer is the output.
    std::vector<Layer> layers() const;
    // The convolutions of layers().
    std::vector<ConvShape> convs() const;
    size_t parameterCount() const;
    // Number of multiply-adds per map.
    double macs() const;
    bool operator==(const UNetShape&) const = default;

    // The metadata keys "architecture", "width", "levels", "size", "inputs".
    StringMap toMetadata() const;
    // Throws drc::Error (one line, with the file name) if a key is missing or its value is not supported.
    static UNetShape fromMetadata(const SafetensorsFile& file);
};

}  // namespace drc
