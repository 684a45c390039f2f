// The image files of a scene's textures. Each is read once and shared by all textures that use it.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "pbrt/source.h"
#include "scene/mip_pyramid.h"

namespace drc::pbrt {

// Whether texels are sRGB-encoded: as pbrt's parameter "gamma" says, or depending on the file's format.
enum class TexelGamma { FromFile, Srgb, Linear };

class TextureFiles {
  public:
    // Throws Error at pos if the file cannot be read.
    std::shared_ptr<const RgbPyramid> color(const std::string& path, TexelGamma gamma, const SourcePos& pos);
    std::shared_ptr<const FloatPyramid> scalar(const std::string& path, TexelGamma gamma, const SourcePos& pos);

  private:
    template <typename T>
    using Cache = std::map<std::pair<std::string, TexelGamma>, std::shared_ptr<const MipPyramid<T>>>;
    template <typename T>
    static std::shared_ptr<const MipPyramid<T>> find(Cache<T>& cache, const std::string& path, TexelGamma gamma,
                                                     const SourcePos& pos);

    Cache<Rgb> colors_;
    Cache<float> scalars_;
};

}  // namespace drc::pbrt
