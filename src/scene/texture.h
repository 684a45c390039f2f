// A texture: a value that varies over a surface (PBR 3e, chapter 10).
#pragma once
#include <memory>

#include "math/vec.h"

namespace drc {

// Where a texture is looked up. Lengths are in world units.
struct TextureContext {
    Vec3 p{0.f};  // world space
    Vec3 n{0.f};  // shading normal, world space
    Vec2 uv{0.f};
    Vec3 dpdu{0.f}, dpdv{0.f};  // world-space derivatives of position by u and v
    float footprint = 0;        // width of the pixel's or path's cone where it meets the surface; 0: finest level
    // The same, in uv units: footprint divided by the length of a unit of uv.
    float uvFootprint = 0;
    // Axes of the ellipse in which the cone meets the surface, as long as it is wide, and how uv changes along each;
    // zero: finest level. setFootprint makes all of these.
    Vec3 dpdx{0.f}, dpdy{0.f};
    Vec2 duvdx{0.f}, duvdy{0.f};
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

template <typename T>
std::shared_ptr<const Texture<T>> constantTexture(const T& value) {
    return std::make_shared<ConstantTexture<T>>(value);
}

// Whether both give the same value everywhere, so that choosing between them by place is of no use.
template <typename T>
bool areEqualConstants(const Texture<T>& a, const Texture<T>& b) {
    return a.isConstant() && b.isConstant() && a.eval({}) == b.eval({});
}

}  // namespace drc
