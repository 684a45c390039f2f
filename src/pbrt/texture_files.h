// The image files of a scene's textures. Each is read once and shared by all textures that use it. They are read on
// other threads while the scene's file is.
#pragma once
#include <compare>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "pbrt/source.h"
#include "scene/textures/mip_pyramid.h"

namespace drc::pbrt {

// Whether texels are sRGB-encoded: as pbrt's parameters "gamma" and "encoding" say, or depending on the file's format.
enum class TexelGamma { FromFile, Srgb, Linear };
// The number that a colour stands for: its luminance (pbrt-v3), or the mean of its channels (pbrt-v4), where an image
// with an alpha channel that is not 1 everywhere is its alpha.
enum class ColorNumber { Luminance, MeanOrAlpha };

// How a texture reads its file.
struct TexelReading {
    TexelGamma gamma = TexelGamma::FromFile;
    float power = 0;  // of "gamma x": integers are decoded by this power; 0: by `gamma`
    ColorNumber number = ColorNumber::Luminance;
    auto operator<=>(const TexelReading&) const = default;
};

class TextureFiles {
  public:
    // The pyramid is empty until finish(). pos: where the scene names the file, for errors.
    std::shared_ptr<const RgbPyramid> color(const std::string& path, const TexelReading& how, const SourcePos& pos);
    std::shared_ptr<const FloatPyramid> scalar(const std::string& path, const TexelReading& how, const SourcePos& pos);

    // Waits until all files asked for are read. Throws Error, at the position of the first that cannot be.
    void finish();
    // The size of all pyramids; valid after finish().
    size_t bytes() const;

  private:
    struct Reading {
        SourcePos pos;
        std::exception_ptr error;
    };
    template <typename T>
    using Cache = std::map<std::pair<std::string, TexelReading>, std::shared_ptr<MipPyramid<T>>>;
    template <typename T>
    std::shared_ptr<const MipPyramid<T>> find(Cache<T>& cache, const std::string& path, const TexelReading& how,
                                              const SourcePos& pos);

    Cache<Rgb> colors_;
    Cache<float> scalars_;
    std::vector<std::unique_ptr<Reading>> readings_;  // in the order in which they were asked for
    BackgroundTasks tasks_;                           // last, so that it ends before what it works on
};

}  // namespace drc::pbrt
