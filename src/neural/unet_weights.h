// The numbers of one trained U-Net, read once and shared by every thread's UNet.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "neural/transforms.h"
#include "neural/unet_shape.h"

namespace drc {

class PackedWeights;

class UNetWeights {
  public:
    struct Conv {
        ConvShape shape;
        std::vector<float> weight;        // [out][in][kernel][kernel], or [out][1][kernel][kernel] if depthwise
        std::vector<float> bias;          // [out]
        std::vector<float> scale, shift;  // [out] if affine, else empty
    };

    // Reads and checks a weights file: the architecture, the shape of every tensor, that all numbers are finite, and
    // that nothing is missing or left over. Throws drc::Error: one line that begins with the file's name.
    static std::shared_ptr<const UNetWeights> load(const std::string& path);
    // He initialisation for LeakyReLU and small random biases: for tests and benchmarks.
    static std::shared_ptr<const UNetWeights> random(const UNetShape& shape, uint64_t seed);
    // `convs` in the order of shape.convs().
    UNetWeights(const UNetShape& shape, std::vector<Conv> convs, StringMap metadata = {}, std::string hash = "");
    ~UNetWeights();
    UNetWeights(const UNetWeights&) = delete;
    UNetWeights& operator=(const UNetWeights&) = delete;

    // Writes a file that load() reads back; `provenance` joins the architecture's own metadata.
    void save(const std::string& path, const StringMap& provenance, DType type = DType::F32) const;

    const UNetShape& shape() const { return shape_; }
    const std::vector<Conv>& convs() const { return convs_; }
    // All of the file's metadata, provenance included.
    const StringMap& metadata() const { return metadata_; }
    // The maps' projection that the network learned with; "" if unknown.
    std::string projection() const;
    // What it was not shown while it learned, and therefore must not be shown.
    Ablation ablation() const { return ablation_; }
    // contentHash of the file; "" for weights that did not come from one.
    const std::string& hash() const { return hash_; }
    // The same numbers in the layouts that the convolutions want. Thread-safe; each layout is made once.
    PackedWeights& packed() const { return *packed_; }

  private:
    UNetShape shape_;
    std::vector<Conv> convs_;
    StringMap metadata_;
    Ablation ablation_ = Ablation::None;
    std::string hash_;
    std::unique_ptr<PackedWeights> packed_;
};

}  // namespace drc
