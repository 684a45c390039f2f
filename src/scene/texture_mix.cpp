#include "scene/texture_mix.h"

namespace drc {
namespace {

template <typename T>
class MixTexture final : public Texture<T> {
  public:
    MixTexture(std::shared_ptr<const Texture<T>> a, std::shared_ptr<const Texture<T>> b, FloatTexturePtr amount)
        : a_(std::move(a)), b_(std::move(b)), amount_(std::move(amount)) {}
    T eval(const TextureContext& at) const override {
        const float amount = amount_->eval(at);
        return a_->eval(at) * (1 - amount) + b_->eval(at) * amount;
    }
    bool isConstant() const override { return a_->isConstant() && b_->isConstant() && amount_->isConstant(); }

  private:
    std::shared_ptr<const Texture<T>> a_, b_;
    FloatTexturePtr amount_;
};

}  // namespace

template <typename T>
std::shared_ptr<const Texture<T>> makeMixTexture(std::shared_ptr<const Texture<T>> a,
                                                 std::shared_ptr<const Texture<T>> b, FloatTexturePtr amount) {
    return std::make_shared<MixTexture<T>>(std::move(a), std::move(b), std::move(amount));
}
template FloatTexturePtr makeMixTexture<float>(FloatTexturePtr, FloatTexturePtr, FloatTexturePtr);
template RgbTexturePtr makeMixTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, FloatTexturePtr);

}  // namespace drc
