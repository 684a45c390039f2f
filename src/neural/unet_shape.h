// The U-Net's architecture as numbers: what the renderer, the trainer and the weights file must agree on.
// Encoder level l works at size/2^l with width*2^l channels (two 3x3 convolutions, LeakyReLU 0.2, then a 2x2 max pool
// but for the last level). The decoder goes back up: bilinear x2, the encoder's result of that level in front
// (channels: skip first, then upsampled), two 3x3 convolutions, LeakyReLU. A 1x1 convolution and a ReLU end it.
// No batch normalisation: the trained graph is the graph that runs.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "neural/safetensors.h"

namespace drc {

inline constexpr float kLeakySlope = 0.2f;

// Tensors: name + ".weight" [out][in][kernel][kernel] and name + ".bias" [out].
struct ConvShape {
    std::string name;
    int in = 0, out = 0, kernel = 3;

    size_t weightCount() const { return size_t(out) * in * kernel * kernel; }
};

struct UNetShape {
    int width = 32;
    int levels = 4;
    int size = 32;
    int inputs = 7;
    int outputs = 3;

    int channels(int level) const { return width << level; }
    int sizeAt(int level) const { return size >> level; }
    // In order of evaluation: enc0.0 enc0.1 enc1.0 ... then dec{levels-2}.0 ... dec0.1, out.
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
