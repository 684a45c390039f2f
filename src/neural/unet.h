// The U-Net's forward pass on the CPU: noisy radiance maps in, clean ones out, both on the network's scale (see
// transforms.h). Jiang & Kainz, "Deep Radiance Caching: Convolutional Autoencoders Deeper in Ray Tracing".
#pragma once
#include <memory>

#include "neural/unet_weights.h"

namespace drc {

enum class Precision { Fp32, Bf16 };

// Whether this machine multiplies bf16 in hardware. Without it bf16 works where oneDNN has a path, but is not faster.
bool cpuHasBf16();
// Bf16 where the hardware has it.
Precision defaultPrecision();
// Whether networks of this kind are run in bf16 when asked to. Separable ones are not: with more convolutions in a row
// they round more often, and with random weights are off by up to .03, where a parity of .02 is promised.
bool runsInBf16(UNetKind kind);

// One instance a thread; the instances share the packed weights. Runs on the calling thread alone, and allocates
// nothing after construction. The same input gives the same bits on any thread and in any slot of the batch.
class UNet {
  public:
    // `batch`: maps a pass; 8 gets all the speed there is. Bf16 becomes Fp32 where not runsInBf16. Throws drc::Error if
    // oneDNN cannot run the precision here.
    UNet(std::shared_ptr<const UNetWeights> weights, int batch, Precision precision = defaultPrecision());
    ~UNet();
    UNet(UNet&&) noexcept;
    UNet& operator=(UNet&&) noexcept;

    // input [count][7][size][size], output [count][3][size][size]; any count. A pass always costs a whole batch.
    void run(const float* input, float* output, int count);

    const UNetShape& shape() const;
    int batch() const;
    Precision precision() const;
    // Memory of this instance, the shared weights not counted.
    size_t memoryBytes() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace drc
