#include "scene/textures/texture_convert.h"

#include <algorithm>
#include <utility>

namespace drc {
namespace {

float inverted(float x) { return std::max(0.f, 1 - x); }
Rgb inverted(const Rgb& c) { return clampNonNegative(Rgb(1.f) - c); }

template <typename T>
class InvertedTexture final : public Texture<T> {
  public:
    explicit InvertedTexture(std::shared_ptr<const Texture<T>> texture) : texture_(std::move(texture)) {}
    T eval(const TextureContext& at) const override { return inverted(texture_->eval(at)); }
    bool isConstant() const override { return texture_->isConstant(); }

  private:
    std::shared_ptr<const Texture<T>> texture_;
};

Rgb clamped(const Rgb& c, float most) {
    return Rgb(std::clamp(c.x, 0.f, most), std::clamp(c.y, 0.f, most), std::clamp(c.z, 0.f, most));
}

class ClampedTexture final : public RgbTexture {
  public:
    ClampedTexture(RgbTexturePtr texture, float most) : texture_(std::move(texture)), most_(most) {}
    Rgb eval(const TextureContext& at) const override { return clamped(texture_->eval(at), most_); }

  private:
    RgbTexturePtr texture_;
    float most_;
};

class GreyTexture final : public RgbTexture {
  public:
    explicit GreyTexture(FloatTexturePtr number) : number_(std::move(number)) {}
    Rgb eval(const TextureContext& at) const override { return Rgb(number_->eval(at)); }
    bool isConstant() const override { return number_->isConstant(); }

  private:
    FloatTexturePtr number_;
};

class RemainderTexture final : public RgbTexture {
  public:
    explicit RemainderTexture(FloatTexturePtr share) : share_(std::move(share)) {}
    Rgb eval(const TextureContext& at) const override { return Rgb(1 - std::clamp(share_->eval(at), 0.f, 1.f)); }
    bool isConstant() const override { return share_->isConstant(); }

  private:
    FloatTexturePtr share_;
};

}  // namespace

template <typename T>
std::shared_ptr<const Texture<T>> makeInvertedTexture(std::shared_ptr<const Texture<T>> texture) {
    return std::make_shared<InvertedTexture<T>>(std::move(texture));
}
template FloatTexturePtr makeInvertedTexture<float>(FloatTexturePtr);
template RgbTexturePtr makeInvertedTexture<Rgb>(RgbTexturePtr);

RgbTexturePtr makeClampedTexture(RgbTexturePtr texture, float most) {
    if (texture->isConstant()) return constantTexture(clamped(texture->eval({}), most));
    return std::make_shared<ClampedTexture>(std::move(texture), most);
}

RgbTexturePtr makeGreyTexture(FloatTexturePtr number) { return std::make_shared<GreyTexture>(std::move(number)); }

RgbTexturePtr makeRemainderTexture(FloatTexturePtr share) {
    return std::make_shared<RemainderTexture>(std::move(share));
}

}  // namespace drc
