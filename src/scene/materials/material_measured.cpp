#include "scene/materials/material_measured.h"

namespace drc {
namespace {

class Measured final : public Material {
  public:
    Measured(std::shared_ptr<const MeasuredTable> table, Relief relief) : table_(std::move(table)) {
        setRelief(std::move(relief));
    }
    void addLobes(const TextureContext&, const Rgb& weight, Bsdf& bsdf) const override {
        bsdf.add(MeasuredBsdf(*table_), weight);
    }
    bool isConstant() const override { return true; }
    int maxLobes() const override { return 1; }

  private:
    std::shared_ptr<const MeasuredTable> table_;
};

}  // namespace

MaterialPtr makeMeasured(std::shared_ptr<const MeasuredTable> table, Relief relief) {
    return std::make_shared<Measured>(std::move(table), std::move(relief));
}

}  // namespace drc
