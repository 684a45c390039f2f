// A texture: a value that varies over a surface (PBR 3e, chapter 10).
#pragma once
#include <memory>

#include "math/vec.h"

namespace drc {

// Where a texture is looked up. Lengths are in world units.
struct TextureContext {
    Vec3 p;  // world space
    Vec3 n;  // shading normal, world space
    Vec2 uv;
    Vec3 dpdu, dpdv;      // world-space derivatives of position by u and v
    float footprint = 0;  // width of the pixel's or path's cone where it meets the surface; 0: finest level
    // The same, in uv units: footprint divided by the length of a unit of uv.
    float uvFootprint = 0;
};

template <typename T>
class Texture {
  public:
    virtual ~Texture() = default;
    virtual T eval(const TextureContext& at) const = 0;
    // True if eval is the same everywhere.
    virtual bool isConstant() const { return false; }
};

using FloatTexture = Texture<float>;
using RgbTexture = Texture<Rgb>;
using FloatTexturePtr = std::shared_ptr<const FloatTexture>;
using RgbTexturePtr = std::shared_ptr<const RgbTexture>;

template <typename T>
class ConstantTexture final : public Texture<T> {
  public:
    explicit ConstantTexture(const T& value) : value_(value) {}
    T eval(const TextureContext&) const override { return value_; }
    bool isConstant() const override { return true; }

  private:
    T value_;
};

}  // namespace drc
