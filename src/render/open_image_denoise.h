// Intel's Open Image Denoise, if the machine has it: loaded when it is asked for, since Debian does not package it.
// Both of its interfaces are understood, that of versions 1 and 2.
#pragma once
#include <memory>
#include <string>

#include "image/image.h"

namespace drc {

enum class OidnQuality { High, Balanced, Fast };

// What a picture's time is worth. Noisy albedo and normal are filtered first and then taken as clean, or guide the
// filter as they are, which is cheaper. Without prefilter, version 2.5 takes the same filter for high and for balanced
// on a CPU, bit by bit.
struct OidnSettings {
    OidnQuality quality = OidnQuality::High;
    bool prefilter = true;

    bool operator==(const OidnSettings&) const = default;
};

class OpenImageDenoise {
  public:
    // library: a file, or empty: what the system finds by its usual names. Throws Error that says what is missing and
    // where to get it.
    explicit OpenImageDenoise(const std::string& library);
    ~OpenImageDenoise();
    OpenImageDenoise(const OpenImageDenoise&) = delete;
    OpenImageDenoise& operator=(const OpenImageDenoise&) = delete;

    // The picture (RGB, linear radiance) without noise. Albedo and normal: RGB each, of the first surface that is no
    // mirror or glass; zero where there is none. All of the same size. On as many threads as loops use. A library that
    // is older than the wanted quality (balanced: 2.0, fast: 2.3) takes the next better one that it has, and a warning
    // says so. Throws Error if the library fails.
    Image denoised(const Image& color, const Image& albedo, const Image& normal,
                   const OidnSettings& settings = {}) const;

    // Of the library: 10000 major + 100 minor + patch.
    int version() const;

  private:
    struct Library;
    std::unique_ptr<Library> library_;
};

}  // namespace drc
