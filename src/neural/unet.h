// The U-Net's forward pass on the CPU: takes noisy radiance maps and returns clean ones, both encoded as in
// transforms.h. Jiang & Kainz, "Deep Radiance Caching: Convolutional Autoencoders Deeper in Ray Tracing".
#pragma once
#include <memory>

#include "neural/unet_weights.h"

namespace drc {

enum class Precision { Fp32, Bf16 };

// Whether this processor multiplies bf16 in hardware. Without that, bf16 works where oneDNN implements it, but is not
// faster.
bool cpuHasBf16();
// Error of bf16 against fp32 for these weights, in encoded units: the largest difference over a few small maps of
// noise.
float bf16Error(const UNetWeights& weights);
// Bf16 if the hardware supports it and these weights tolerate it, otherwise Fp32. Results are promised to be within .02
// of full precision. The limit for bf16Error() is .008, because on five whole maps the error was up to 2.2 times what
// bf16Error() found (24 random networks).
Precision bestPrecision(const UNetWeights& weights);

// One instance per thread; all instances share the packed weights. Runs on the calling thread only, and allocates
// nothing after construction. The same input gives the same bits on any thread and at any position in the batch.
class UNet {
  public:
    // `batch`: maps per pass; 8 are enough for full speed. Throws drc::Error if oneDNN does not support the precision
    // here.
    UNet(std::shared_ptr<const UNetWeights> weights, int batch, Precision precision);
    ~UNet();
    UNet(UNet&&) noexcept;
    UNet& operator=(UNet&&) noexcept;

    // input [count][7 or 13][size][size], output [count][3][size][size], for any count. A pass always costs a whole
    // batch.
    void run(const float* input, float* output, int count);

    const UNetShape& shape() const;
    int batch() const;
    // Memory of this instance, without the shared weights, in bytes.
    size_t memoryBytes() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace drc
