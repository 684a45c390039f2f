#include "scene/textures/texture_bilerp.h"

namespace drc {
namespace {

template <typename T>
class Bilerp final : public Texture<T> {
  public:
    Bilerp(const BilerpCorners<T>& corners, const Mapping2D& mapping) : corners_(corners), mapping_(mapping) {}
    T eval(const TextureContext& at) const override {
        const Vec2 st = mapping_.at(at).st;
        return lerp(st.x, lerp(st.y, corners_.v00, corners_.v01), lerp(st.y, corners_.v10, corners_.v11));
    }

  private:
    BilerpCorners<T> corners_;
    Mapping2D mapping_;
};

}  // namespace

template <typename T>
std::shared_ptr<const Texture<T>> makeBilerpTexture(const BilerpCorners<T>& c, const Mapping2D& mapping) {
    if (c.v00 == c.v01 && c.v00 == c.v10 && c.v00 == c.v11) return constantTexture(c.v00);
    return std::make_shared<Bilerp<T>>(c, mapping);
}
template FloatTexturePtr makeBilerpTexture<float>(const BilerpCorners<float>&, const Mapping2D&);
template RgbTexturePtr makeBilerpTexture<Rgb>(const BilerpCorners<Rgb>&, const Mapping2D&);

}  // namespace drc
