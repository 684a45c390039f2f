// The U-Net's forward pass on the CPU: denoises radiance maps; input and output are encoded as in transforms.h. Jiang &
// Kainz, "Deep Radiance Caching: Convolutional Autoencoders Deeper in Ray Tracing".
#pragma once
#include <memory>

#include "neural/unet_weights.h"

namespace drc {

enum class Precision { Fp32, Bf16 };

// Whether this processor multiplies bf16 in hardware. Otherwise bf16 works wherever oneDNN implements it, but is not
// faster.
bool cpuHasBf16();
// Error of bf16 relative to fp32 for these weights: the largest absolute difference of the outputs, in encoded units,
// over a few small maps of noise.
float bf16Error(const UNetWeights& weights);
// Bf16 if the hardware supports it and these weights tolerate it, otherwise Fp32. The guarantee is an error within .02
// of full precision, in encoded units. The limit for bf16Error() is .008, because the error on five whole maps was up
// to 2.2 times bf16Error() (24 random networks).
Precision bestPrecision(const UNetWeights& weights);

// Use one instance per thread; all instances share the packed weights. Runs on the calling thread only, and allocates
// nothing after construction. Equal inputs give equal bits on any thread and at any position in the batch.
class UNet {
  public:
    // `batch`: maps per pass; 8 are enough for full speed. Throws drc::Error if oneDNN does not support the precision
    // on this machine.
    UNet(std::shared_ptr<const UNetWeights> weights, int batch, Precision precision);
    ~UNet();
    UNet(UNet&&) noexcept;
    UNet& operator=(UNet&&) noexcept;

    // input [count][7 or 13][size][size], output [count][3][size][size], for any count. Every started batch costs as
    // much as a full one.
    void run(const float* input, float* output, int count);

    const UNetShape& shape() const;
    int batch() const;
    // Memory of this instance in bytes, without the shared weights.
    size_t memoryBytes() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace drc
