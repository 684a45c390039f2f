#include "scene/textures/texture_dots.h"

#include "scene/textures/noise.h"

namespace drc {
namespace {

constexpr float kRadius = 0.35f;
constexpr float kGreatestShift = 0.5f - kRadius;  // keeps dots inside their squares

// A pseudo-random number in about [-1, 1] for each square: noise at the offset (s, t) from the square's corner, which
// lies off the lattice points, because noise is zero there.
float numberOf(const Vec2& square, float s, float t) { return noise(Vec3(square.x + s, square.y + t, 0.5f)); }

bool isInDot(const Vec2& st) {
    const Vec2 square(std::floor(st.x + 0.5f), std::floor(st.y + 0.5f));
    if (!(numberOf(square, 0.5f, 0.5f) > 0)) return false;
    // pbrt's offsets, so that the dots lie where pbrt places them.
    const Vec2 shift = Vec2(numberOf(square, 1.5f, 2.8f), numberOf(square, 4.5f, 9.8f)) * kGreatestShift;
    return (st - square - shift).length2() < kRadius * kRadius;
}

template <typename T>
class Dots final : public Texture<T> {
  public:
    Dots(std::shared_ptr<const Texture<T>> inside, std::shared_ptr<const Texture<T>> outside, const Mapping2D& mapping)
        : inside_(std::move(inside)), outside_(std::move(outside)), mapping_(mapping) {}
    T eval(const TextureContext& at) const override {
        return (isInDot(mapping_.at(at).st) ? inside_ : outside_)->eval(at);
    }

  private:
    std::shared_ptr<const Texture<T>> inside_, outside_;
    Mapping2D mapping_;
};

}  // namespace

template <typename T>
std::shared_ptr<const Texture<T>> makeDotsTexture(std::shared_ptr<const Texture<T>> inside,
                                                  std::shared_ptr<const Texture<T>> outside, const Mapping2D& mapping) {
    if (areEqualConstants(*inside, *outside)) return inside;
    return std::make_shared<Dots<T>>(std::move(inside), std::move(outside), mapping);
}
template FloatTexturePtr makeDotsTexture<float>(FloatTexturePtr, FloatTexturePtr, const Mapping2D&);
template RgbTexturePtr makeDotsTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, const Mapping2D&);

}  // namespace drc
