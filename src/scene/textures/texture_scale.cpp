#include "scene/textures/texture_scale.h"

namespace drc {
namespace {

template <typename T>
class Scale final : public Texture<T> {
  public:
    Scale(std::shared_ptr<const Texture<T>> a, std::shared_ptr<const Texture<T>> b)
        : a_(std::move(a)), b_(std::move(b)) {}
    T eval(const TextureContext& at) const override { return a_->eval(at) * b_->eval(at); }

  private:
    std::shared_ptr<const Texture<T>> a_, b_;
};

template <typename T>
class ScaleByConstant final : public Texture<T> {
  public:
    ScaleByConstant(std::shared_ptr<const Texture<T>> texture, const T& factor)
        : texture_(std::move(texture)), factor_(factor) {}
    T eval(const TextureContext& at) const override { return texture_->eval(at) * factor_; }

  private:
    std::shared_ptr<const Texture<T>> texture_;
    T factor_;
};

template <typename T>
std::shared_ptr<const Texture<T>> scaled(std::shared_ptr<const Texture<T>> texture, const T& factor) {
    if (texture->isConstant()) return constantTexture(T(texture->eval({}) * factor));
    if (factor == T(1.f)) return texture;
    return std::make_shared<ScaleByConstant<T>>(std::move(texture), factor);
}

}  // namespace

template <typename T>
std::shared_ptr<const Texture<T>> makeScaleTexture(std::shared_ptr<const Texture<T>> a,
                                                   std::shared_ptr<const Texture<T>> b) {
    if (b->isConstant()) return scaled<T>(std::move(a), b->eval({}));
    if (a->isConstant()) return scaled<T>(std::move(b), a->eval({}));
    return std::make_shared<Scale<T>>(std::move(a), std::move(b));
}
template FloatTexturePtr makeScaleTexture<float>(FloatTexturePtr, FloatTexturePtr);
template RgbTexturePtr makeScaleTexture<Rgb>(RgbTexturePtr, RgbTexturePtr);

}  // namespace drc
