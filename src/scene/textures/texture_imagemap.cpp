#include "scene/textures/texture_imagemap.h"

namespace drc {
namespace {

template <typename T>
class ImageMap final : public Texture<T> {
  public:
    ImageMap(std::shared_ptr<const MipPyramid<T>> pyramid, const ImageMapParams& params)
        : pyramid_(std::move(pyramid)), params_(params) {}
    T eval(const TextureContext& at) const override {
        const PlanePoint point = params_.mapping.at(at);
        if (!params_.trilinear)
            return pyramid_->lookup(point.st, point.dstdx, point.dstdy, params_.maxAnisotropy, params_.wrap) *
                   params_.scale;
        const float width = std::max(
            {std::abs(point.dstdx.x), std::abs(point.dstdx.y), std::abs(point.dstdy.x), std::abs(point.dstdy.y)});
        return pyramid_->lookup(point.st, 2 * width, params_.wrap) * params_.scale;
    }

  private:
    std::shared_ptr<const MipPyramid<T>> pyramid_;
    ImageMapParams params_;
};

}  // namespace

RgbTexturePtr makeImageMap(std::shared_ptr<const RgbPyramid> pyramid, const ImageMapParams& params) {
    return std::make_shared<ImageMap<Rgb>>(std::move(pyramid), params);
}

FloatTexturePtr makeImageMap(std::shared_ptr<const FloatPyramid> pyramid, const ImageMapParams& params) {
    return std::make_shared<ImageMap<float>>(std::move(pyramid), params);
}

}  // namespace drc
