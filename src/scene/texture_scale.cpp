#include "scene/texture_scale.h"

namespace drc {
namespace {

template <typename T>
class Scale final : public Texture<T> {
  public:
    Scale(std::shared_ptr<const Texture<T>> a, std::shared_ptr<const Texture<T>> b)
        : a_(std::move(a)), b_(std::move(b)) {}
    T eval(const TextureContext& at) const override { return a_->eval(at) * b_->eval(at); }
    bool isConstant() const override { return a_->isConstant() && b_->isConstant(); }

  private:
    std::shared_ptr<const Texture<T>> a_, b_;
};

}  // namespace

template <typename T>
std::shared_ptr<const Texture<T>> makeScaleTexture(std::shared_ptr<const Texture<T>> a,
                                                   std::shared_ptr<const Texture<T>> b) {
    return std::make_shared<Scale<T>>(std::move(a), std::move(b));
}
template FloatTexturePtr makeScaleTexture<float>(FloatTexturePtr, FloatTexturePtr);
template RgbTexturePtr makeScaleTexture<Rgb>(RgbTexturePtr, RgbTexturePtr);

}  // namespace drc
