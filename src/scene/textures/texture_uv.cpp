#include "scene/textures/texture_uv.h"

namespace drc {
namespace {

class UvTexture final : public RgbTexture {
  public:
    explicit UvTexture(const Mapping2D& mapping) : mapping_(mapping) {}
    Rgb eval(const TextureContext& at) const override {
        const Vec2 st = mapping_.at(at).st;
        return Rgb(st.x - std::floor(st.x), st.y - std::floor(st.y), 0);
    }

  private:
    Mapping2D mapping_;
};

}  // namespace

RgbTexturePtr makeUvTexture(const Mapping2D& mapping) { return std::make_shared<UvTexture>(mapping); }

}  // namespace drc
