#include "scene/materials/material_mirror.h"

#include "scene/materials/material_params.h"

namespace drc {
namespace {

class Mirror final : public Material {
  public:
    explicit Mirror(MirrorParams params) : params_(std::move(params)) {
        params_.kr = orConstant(params_.kr, Rgb(0.9f));
        setRelief(params_.relief);
    }
    void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const override {
        const Rgb kr = evalClamped(*params_.kr, at);
        if (!isBlack(kr)) bsdf.add(SpecularReflection(kr, Fresnel::none()), weight);
    }

    bool isConstant() const override { return areConstant(params_.kr); }
    int maxLobes() const override { return 1; }

  private:
    MirrorParams params_;
};

}  // namespace

MaterialPtr makeMirror(MirrorParams params) { return std::make_shared<Mirror>(std::move(params)); }

}  // namespace drc
