// The weights of a trained U-Net, read once and shared by the UNet instances of all threads.
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
        std::vector<float> scale, shift;  // [out] if affine, otherwise empty
    };

    // Reads and checks a weights file: the architecture, the shape of every tensor, that all values are finite, and
    // that no tensor is missing or superfluous. Throws drc::Error, one line that begins with the file name.
    static std::shared_ptr<const UNetWeights> load(const std::string& path);
    // Random weights for tests and benchmarks: He initialisation for LeakyReLU, and small random biases.
    static std::shared_ptr<const UNetWeights> random(const UNetShape& shape, uint64_t seed);
    // `convs`: in the order of shape.convs().
    UNetWeights(const UNetShape& shape, std::vector<Conv> convs, StringMap metadata = {}, std::string hash = "");
    ~UNetWeights();
    UNetWeights(const UNetWeights&) = delete;
    UNetWeights& operator=(const UNetWeights&) = delete;

    // Writes a file that load() can read. `provenance`: further metadata beside the architecture's.
    void save(const std::string& path, const StringMap& provenance, DType type = DType::F32) const;

    const UNetShape& shape() const { return shape_; }
    const std::vector<Conv>& convs() const { return convs_; }
    // All metadata of the file, including provenance.
    const StringMap& metadata() const { return metadata_; }
    // Projection of the maps that the network was trained with; "" if unknown.
    std::string projection() const;
    // The inputs that were hidden in training, and must be hidden at run time too.
    Ablation ablation() const { return ablation_; }
    // SafetensorsFile::contentHash of the file; "" for weights that do not come from a file.
    const std::string& hash() const { return hash_; }
    // The weights in the layouts that oneDNN's convolutions use. Thread-safe; each layout is made once.
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
