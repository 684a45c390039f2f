// The U-Net's forward pass on the CPU: noisy radiance maps in, clean ones out, both on the network's scale (see
// transforms.h). Jiang & Kainz, "Deep Radiance Caching: Convolutional Autoencoders Deeper in Ray Tracing".
#pragma once
#include <memory>

#include "neural/unet_weights.h"

namespace drc {

enum class Precision { Fp32, Bf16 };

// Whether this machine multiplies bf16 in hardware. Without it bf16 works where oneDNN has a path, but is not faster.
bool cpuHasBf16();
// How far bf16 takes these weights' results from fp32's, on the network's scale: the largest difference over a few
// small maps of noise, which are run in both.
float bf16Error(const UNetWeights& weights);
// Bf16 where the hardware has it and these weights bear it, Fp32 elsewhere. Results are promised to be within .02 of
// those in full precision; weights bear bf16 if their bf16Error is at most .008, as five whole maps were seen to find
// up to 2.2 times as much (24 random networks).
Precision bestPrecision(const UNetWeights& weights);

// One instance a thread; the instances share the packed weights. Runs on the calling thread alone, and allocates
// nothing after construction. The same input gives the same bits on any thread and in any slot of the batch.
class UNet {
  public:
    // `batch`: maps a pass; 8 gets all the speed there is. Throws drc::Error if oneDNN cannot run the precision here.
    UNet(std::shared_ptr<const UNetWeights> weights, int batch, Precision precision);
    ~UNet();
    UNet(UNet&&) noexcept;
    UNet& operator=(UNet&&) noexcept;

    // input [count][7][size][size], output [count][3][size][size]; any count. A pass always costs a whole batch.
    void run(const float* input, float* output, int count);

    const UNetShape& shape() const;
    int batch() const;
    // Memory of this instance, the shared weights not counted.
    size_t memoryBytes() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace drc
