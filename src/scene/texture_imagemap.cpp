#include "scene/texture_imagemap.h"

namespace drc {
namespace {

template <typename T>
class ImageMap final : public Texture<T> {
  public:
    ImageMap(std::shared_ptr<const MipPyramid<T>> pyramid, const ImageMapParams& params)
        : pyramid_(std::move(pyramid)),
          params_(params),
          widthScale_(std::max(std::abs(params.mapping.uScale), std::abs(params.mapping.vScale)) *
                      (params.trilinear ? 2 : 1)) {}
    T eval(const TextureContext& at) const override {
        return pyramid_->lookup(params_.mapping.apply(at.uv), at.uvFootprint * widthScale_, params_.wrap) *
               params_.scale;
    }

  private:
    std::shared_ptr<const MipPyramid<T>> pyramid_;
    ImageMapParams params_;
    float widthScale_;
};

}  // namespace

RgbTexturePtr makeImageMap(std::shared_ptr<const RgbPyramid> pyramid, const ImageMapParams& params) {
    return std::make_shared<ImageMap<Rgb>>(std::move(pyramid), params);
}

FloatTexturePtr makeImageMap(std::shared_ptr<const FloatPyramid> pyramid, const ImageMapParams& params) {
    return std::make_shared<ImageMap<float>>(std::move(pyramid), params);
}

}  // namespace drc
