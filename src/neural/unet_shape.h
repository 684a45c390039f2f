// The U-Net's architecture as numbers: what the renderer, the trainer and the weights file must agree on.
// Encoder level l works at size/2^l with width*2^l channels (a block, then a 2x2 max pool but for the last level). The
// decoder goes back up: bilinear x2, the encoder's result of that level in front (channels: skip first, then
// upsampled), a block. A 1x1 convolution and a ReLU end it. All activations are LeakyReLU 0.2. A block is:
//   Plain      two 3x3 convolutions
//   Residual   the same, and a 1x1 convolution of the block's input added before the last activation
//   Separable  1x1, and then twice: 3x3 on each channel alone, 1x1
//   Paper      as the authors' program has it: two 3x3 convolutions, batch normalisation after the first one's
//              activation (not at full size); the last level's and each decoder's second convolution halve the channels
// Only Paper normalises: for it the trained graph holds a scale and a shift a channel; the others run as they learn.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "neural/safetensors.h"
#include "neural/transforms.h"

namespace drc {

inline constexpr float kLeakySlope = 0.2f;

// Tensors: name + ".weight" [out][in][kernel][kernel] ([out][1][kernel][kernel] if depthwise), name + ".bias" [out]; if
// affine, name + ".scale" and ".shift" [out].
struct ConvShape {
    std::string name;
    int in = 0, out = 0, kernel = 3;
    bool depthwise = false;  // each channel has a filter of its own; in == out
    bool affine = false;     // after the activation: scale y + shift

    int inputsPerFilter() const { return depthwise ? 1 : in; }
    size_t weightCount() const { return size_t(out) * inputsPerFilter() * kernel * kernel; }
    size_t parameterCount() const { return weightCount() + size_t(out) * (affine ? 3 : 1); }
};

enum class LayerOp { Conv, MaxPool, Upsample };

// One step. Values are numbered: 0 is the network's input, i the result of layer i - 1.
struct Layer {
    LayerOp op = LayerOp::Conv;
    int source = 0;
    int size = 0;  // of the result
    // Of convolutions alone:
    ConvShape conv{};
    int skip = -1;    // value that is stacked in front of source
    int add = -1;     // value that is added before the activation; no later layer uses it
    float slope = 1;  // of the activation max(x, slope x); 1: none

    // Variance that random weights should have for results to vary as much as sources do (He et al., "Delving Deep into
    // Rectifiers", 2015). Where two results are added each brings half.
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
    int inputs = kPlainPlanes;  // or kGuidedPlanes
    int outputs = kOutputPlanes;

    int channels(int level) const { return width << level; }
    int sizeAt(int level) const { return size >> level; }
    // In order of evaluation. The last one's result is the output.
    std::vector<Layer> layers() const;
    // The convolutions of layers().
    std::vector<ConvShape> convs() const;
    size_t parameterCount() const;
    // Multiply-adds for one map.
    double macs() const;
    bool operator==(const UNetShape&) const = default;

    // The metadata keys "architecture", "width", "levels", "size", "inputs".
    StringMap toMetadata() const;
    // Throws drc::Error (one line, with the file's name) if a key is missing or its value is not one we can run.
    static UNetShape fromMetadata(const SafetensorsFile& file);
};

}  // namespace drc
