// A material turns a point on a surface into a BSDF.
#pragma once
#include <memory>
#include <string>

#include "scene/bsdf.h"
#include "scene/texture.h"

namespace drc {

class Material {
  public:
    virtual ~Material() = default;
    // Adds this material's lobes to the BSDF, each scaled by weight (so that a mix is two calls).
    virtual void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const = 0;
    // True if the lobes are the same everywhere. The bump map does not matter: it turns the frame alone.
    virtual bool isConstant() const = 0;
    // The most lobes that addLobes ever adds. Front ends refuse materials that have more than a Bsdf takes.
    virtual int maxLobes() const = 0;
    // Height field that perturbs the shading normal, world units along the normal; null: none.
    virtual const FloatTexture* bump() const { return bump_.get(); }
    void setBump(FloatTexturePtr bump) { bump_ = std::move(bump); }

  private:
    FloatTexturePtr bump_;
};

using MaterialPtr = std::shared_ptr<const Material>;

}  // namespace drc
