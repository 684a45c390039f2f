#include "scene/materials/material_fourier.h"

namespace drc {
namespace {

class Fourier final : public Material {
  public:
    Fourier(std::shared_ptr<const FourierTable> table, Relief relief) : table_(std::move(table)) {
        setRelief(std::move(relief));
    }
    void addLobes(const TextureContext&, const Rgb& weight, Bsdf& bsdf) const override {
        if (table_->reflects() || table_->transmits()) bsdf.add(FourierBsdf(*table_), weight);
    }
    bool isConstant() const override { return true; }
    int maxLobes() const override { return 1; }

  private:
    std::shared_ptr<const FourierTable> table_;
};

}  // namespace

MaterialPtr makeFourier(std::shared_ptr<const FourierTable> table, Relief relief) {
    return std::make_shared<Fourier>(std::move(table), std::move(relief));
}

}  // namespace drc
