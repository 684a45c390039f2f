// A material computes the BSDF at a point of a surface.
#pragma once
#include <memory>
#include <string>

#include "scene/lobes/bsdf.h"
#include "scene/textures/texture.h"

namespace drc {

// Makes a surface look uneven without displacing it: a height field, in world units along the normal, or a normal map.
// Either may be null; a normal map has precedence.
struct Relief {
    Relief() = default;
    Relief(FloatTexturePtr h, RgbTexturePtr n = nullptr) : heights(std::move(h)), normals(std::move(n)) {}  // implicit
    FloatTexturePtr heights;
    RgbTexturePtr normals;  // see normalMapFrame() (scene/textures/bump.h)
};

class Material {
  public:
    virtual ~Material() = default;
    // Adds this material's lobes to the BSDF, scaled by weight. A mix calls this for each of its two materials.
    virtual void addLobes(const TextureContext& at, const Rgb& weight, Bsdf& bsdf) const = 0;
    // Whether the lobes are the same everywhere. Relief does not count, since it only changes the shading frame.
    virtual bool isConstant() const = 0;
    // Maximum number of lobes that addLobes() adds. Front ends reject materials with more lobes than a Bsdf can hold.
    virtual int maxLobes() const = 0;
    virtual const Relief& relief() const { return relief_; }
    void setRelief(Relief relief) { relief_ = std::move(relief); }

    // Opacity: the share of rays that hit the surface; the others pass through it. Null: all hit it. Front ends apply
    // opacity and emission only to primitives that use this material directly, not as a part of a mix.
    const FloatTexturePtr& opacity() const { return opacity_; }
    // Radiance emitted on both sides; null: none.
    const RgbTexturePtr& emission() const { return emission_; }

  protected:
    void setOpacity(FloatTexturePtr opacity) { opacity_ = std::move(opacity); }
    void setEmission(RgbTexturePtr emission) { emission_ = std::move(emission); }

  private:
    Relief relief_;
    FloatTexturePtr opacity_;
    RgbTexturePtr emission_;
};

using MaterialPtr = std::shared_ptr<const Material>;

}  // namespace drc
