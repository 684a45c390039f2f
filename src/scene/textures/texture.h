// Textures: values that vary over a surface (PBR 3e, chapter 10).
#pragma once
#include <memory>

#include "math/vec.h"

namespace drc {

// The point at which a texture is evaluated, with its filter footprint. Lengths are in world units.
struct TextureContext {
    Vec3 p{0.f};  // world space
    Vec3 n{0.f};  // shading normal, world space
    Vec2 uv{0.f};
    Vec3 dpdu{0.f}, dpdv{0.f};  // world-space derivatives of position with respect to u and v
    float footprint = 0;        // width of the ray cone where it meets the surface; 0: no filtering
    // The footprint in uv units: footprint / (length of a unit of uv).
    float uvFootprint = 0;
    // Axes of the ellipse in which the cone intersects the surface, as full diameters, and the change of uv along each;
    // zero: no filtering. Set by setFootprint().
    Vec3 dpdx{0.f}, dpdy{0.f};
    Vec2 duvdx{0.f}, duvdy{0.f};
};

template <typename T>
class Texture {
  public:
    virtual ~Texture() = default;
    virtual T eval(const TextureContext& at) const = 0;
    // Whether eval() returns the same value everywhere.
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

// Whether both are constants of equal value, so that choosing between them by position makes no difference.
template <typename T>
bool areEqualConstants(const Texture<T>& a, const Texture<T>& b) {
    return a.isConstant() && b.isConstant() && a.eval({}) == b.eval({});
}

}  // namespace drc
