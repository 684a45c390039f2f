#include "scene/textures/texture_checkerboard.h"

namespace drc {
namespace {

// Parity in floating point, since large coordinates would overflow an int.
bool isOdd(float whole) { return std::fmod(whole, 2.f) != 0; }

// Integral from 0 to x of a function that is 0 in even cells and 1 in odd cells.
float integralOfOddCells(float x) {
    const float pairs = std::floor(x / 2);
    return pairs + 2 * std::max(x / 2 - pairs - 0.5f, 0.f);
}

// Share of the interval of the given width around x that lies in odd cells.
float shareOfOddCells(float x, float width) {
    if (!(width > 1e-5f)) return isOdd(std::floor(x)) ? 1.f : 0.f;
    if (width > 2) return 0.5f;  // nearly exact, and large coordinates would cancel
    const float first = x - width / 2;
    if (const float cell = std::floor(first); cell == std::floor(first + width)) return isOdd(cell) ? 1.f : 0.f;
    return std::clamp((integralOfOddCells(first + width) - integralOfOddCells(first)) / width, 0.f, 1.f);
}

template <typename T>
class Checkerboard final : public Texture<T> {
  public:
    Checkerboard(std::shared_ptr<const Texture<T>> a, std::shared_ptr<const Texture<T>> b, const Mapping2D& mapping,
                 CheckerboardEdges edges)
        : a_(std::move(a)), b_(std::move(b)), mapping_(mapping), edges_(edges) {}
    T eval(const TextureContext& at) const override {
        const PlanePoint point = mapping_.at(at);
        if (edges_ == CheckerboardEdges::Sharp)
            return (isOdd(std::floor(point.st.x) + std::floor(point.st.y)) ? b_ : a_)->eval(at);
        // Averages over an axis-aligned box as wide as the footprint.
        const float s = shareOfOddCells(point.st.x, std::max(std::abs(point.dstdx.x), std::abs(point.dstdy.x)));
        const float t = shareOfOddCells(point.st.y, std::max(std::abs(point.dstdx.y), std::abs(point.dstdy.y)));
        const float b = s + t - 2 * s * t;
        if (b <= 0) return a_->eval(at);
        if (b >= 1) return b_->eval(at);
        return a_->eval(at) * (1 - b) + b_->eval(at) * b;
    }

  private:
    std::shared_ptr<const Texture<T>> a_, b_;
    Mapping2D mapping_;
    CheckerboardEdges edges_;
};

template <typename T>
class SolidCheckerboard final : public Texture<T> {
  public:
    SolidCheckerboard(std::shared_ptr<const Texture<T>> a, std::shared_ptr<const Texture<T>> b,
                      const Mapping3D& mapping)
        : a_(std::move(a)), b_(std::move(b)), mapping_(mapping) {}
    T eval(const TextureContext& at) const override {
        const Vec3 p = mapping_.at(at).p;
        return (isOdd(std::floor(p.x) + std::floor(p.y) + std::floor(p.z)) ? b_ : a_)->eval(at);
    }

  private:
    std::shared_ptr<const Texture<T>> a_, b_;
    Mapping3D mapping_;
};

}  // namespace

template <typename T>
std::shared_ptr<const Texture<T>> makeCheckerboardTexture(std::shared_ptr<const Texture<T>> a,
                                                          std::shared_ptr<const Texture<T>> b, const Mapping2D& mapping,
                                                          CheckerboardEdges edges) {
    if (areEqualConstants(*a, *b)) return a;
    return std::make_shared<Checkerboard<T>>(std::move(a), std::move(b), mapping, edges);
}

template <typename T>
std::shared_ptr<const Texture<T>> makeSolidCheckerboardTexture(std::shared_ptr<const Texture<T>> a,
                                                               std::shared_ptr<const Texture<T>> b,
                                                               const Mapping3D& mapping) {
    if (areEqualConstants(*a, *b)) return a;
    return std::make_shared<SolidCheckerboard<T>>(std::move(a), std::move(b), mapping);
}

template FloatTexturePtr makeCheckerboardTexture<float>(FloatTexturePtr, FloatTexturePtr, const Mapping2D&,
                                                        CheckerboardEdges);
template RgbTexturePtr makeCheckerboardTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, const Mapping2D&, CheckerboardEdges);
template FloatTexturePtr makeSolidCheckerboardTexture<float>(FloatTexturePtr, FloatTexturePtr, const Mapping3D&);
template RgbTexturePtr makeSolidCheckerboardTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, const Mapping3D&);

}  // namespace drc
