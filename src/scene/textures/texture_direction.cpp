#include "scene/textures/texture_direction.h"

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

class DirectionTexture final : public FloatTexture {
  public:
    explicit DirectionTexture(const Vec3& direction) : direction_(normalize(direction)) {}
    float eval(const TextureContext& at) const override { return std::min(1.f, std::abs(dot(at.n, direction_))); }

  private:
    Vec3 direction_;
};

}  // namespace

FloatTexturePtr makeDirectionTexture(const Vec3& direction) { return std::make_shared<DirectionTexture>(direction); }

}  // namespace drc
