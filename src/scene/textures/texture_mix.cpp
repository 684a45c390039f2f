#include "scene/textures/texture_mix.h"

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

  private:
    std::shared_ptr<const Texture<T>> a_, b_;
    FloatTexturePtr amount_;
};

}  // namespace

template <typename T>
std::shared_ptr<const Texture<T>> makeMixTexture(std::shared_ptr<const Texture<T>> a,
                                                 std::shared_ptr<const Texture<T>> b, FloatTexturePtr amount) {
    if (areEqualConstants(*a, *b)) return a;
    const bool isFixed = amount->isConstant();
    if (isFixed && amount->eval({}) == 0) return a;
    if (isFixed && amount->eval({}) == 1) return b;
    const bool isConstant = isFixed && a->isConstant() && b->isConstant();
    auto mix = std::make_shared<MixTexture<T>>(std::move(a), std::move(b), std::move(amount));
    if (isConstant) return constantTexture(mix->eval({}));
    return mix;
}
template FloatTexturePtr makeMixTexture<float>(FloatTexturePtr, FloatTexturePtr, FloatTexturePtr);
template RgbTexturePtr makeMixTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, FloatTexturePtr);

}  // namespace drc
