// A material computes the BSDF at a point of a surface.
#pragma once
#include <memory>
#include <string>

#include "scene/bsdf.h"
#include "scene/texture.h"

namespace drc {

class Material {
  public:
    virtual ~Material() = default;
    // Adds this material's lobes to the BSDF, scaled by weight. A mix calls this for each of its two materials.
    virtual void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const = 0;
    // Whether the lobes are the same everywhere. A bump map does not matter, since it only changes the shading frame.
    virtual bool isConstant() const = 0;
    // Maximum number of lobes that addLobes() adds. Front ends reject materials with more lobes than a Bsdf can hold.
    virtual int maxLobes() const = 0;
    // Height field for bump mapping, in world units along the normal; null if there is none.
    virtual const FloatTexture* bump() const { return bump_.get(); }
    void setBump(FloatTexturePtr bump) { bump_ = std::move(bump); }

  private:
    FloatTexturePtr bump_;
};

using MaterialPtr = std::shared_ptr<const Material>;

}  // namespace drc
