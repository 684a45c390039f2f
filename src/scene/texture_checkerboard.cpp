#include "scene/texture_checkerboard.h"

namespace drc {
namespace {

template <typename T>
class Checkerboard final : public Texture<T> {
  public:
    Checkerboard(std::shared_ptr<const Texture<T>> a, std::shared_ptr<const Texture<T>> b, const UvMapping& mapping)
        : a_(std::move(a)), b_(std::move(b)), mapping_(mapping) {}
    T eval(const TextureContext& at) const override {
        const Vec2 st = mapping_.apply(at.uv);
        // Parity without a conversion to int, which far coordinates would overflow.
        const bool odd = std::fmod(std::floor(st.x) + std::floor(st.y), 2.f) != 0;
        return (odd ? b_ : a_)->eval(at);
    }

  private:
    std::shared_ptr<const Texture<T>> a_, b_;
    UvMapping mapping_;
};

}  // namespace

template <typename T>
std::shared_ptr<const Texture<T>> makeCheckerboardTexture(std::shared_ptr<const Texture<T>> a,
                                                          std::shared_ptr<const Texture<T>> b,
                                                          const UvMapping& mapping) {
    return std::make_shared<Checkerboard<T>>(std::move(a), std::move(b), mapping);
}
template FloatTexturePtr makeCheckerboardTexture<float>(FloatTexturePtr, FloatTexturePtr, const UvMapping&);
template RgbTexturePtr makeCheckerboardTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, const UvMapping&);

}  // namespace drc
