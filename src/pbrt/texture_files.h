// The image files of a scene's textures. Each file is read once and shared by all textures that use it. Other threads
// read the images while the scene file is being parsed.
#pragma once
#include <compare>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/file_stamp.h"
#include "base/parallel.h"
#include "pbrt/source.h"
#include "scene/textures/mip_pyramid.h"

namespace drc::pbrt {

// Whether texels are sRGB-encoded: set by pbrt's parameters "gamma" and "encoding", or determined by the file's format.
enum class TexelGamma { FromFile, Srgb, Linear };
// How a colour is reduced to a number: to its luminance (pbrt-v3); or to the mean of its channels, or to alpha in
// images with an alpha channel that is not 1 everywhere (pbrt-v4).
enum class ColorNumber { Luminance, MeanOrAlpha };

// How a texture reads its file.
struct TexelReading {
    TexelGamma gamma = TexelGamma::FromFile;
    float power = 0;  // power to decode integers with, from "gamma x"; 0: decode by `gamma`
    ColorNumber number = ColorNumber::Luminance;
    auto operator<=>(const TexelReading&) const = default;
};

class KeptContents;

class TextureFiles {
  public:
    // Takes images from those of an earlier frame, instead of reading them again. Call before the first request.
    void reuse(const KeptContents& kept) { kept_ = &kept; }
    // Starts reading an image. The pyramid stays empty until finish(). pos: where the scene names the file, for errors.
    std::shared_ptr<const RgbPyramid> color(const std::string& path, const TexelReading& how, const SourcePos& pos);
    std::shared_ptr<const FloatPyramid> scalar(const std::string& path, const TexelReading& how, const SourcePos& pos);

    // Waits until all requested files have been read. Throws Error, located where the scene names it, for the first
    // file that failed.
    void finish();
    // Keeps all images for the next frame, in place of those that were kept. Only after finish().
    void keepIn(KeptContents& kept) const;
    // The memory of all pyramids in bytes; valid after finish().
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

    const KeptContents* kept_ = nullptr;
    std::map<std::string, FileStamp> stamps_;  // of the files, before they were read; empty without kept_
    Cache<Rgb> colors_;
    Cache<float> scalars_;
    std::vector<std::unique_ptr<Reading>> readings_;  // in the order of the requests
    BackgroundTasks tasks_;                           // last member, destroyed first: the tasks use the others
};

}  // namespace drc::pbrt
