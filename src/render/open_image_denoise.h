// Intel's Open Image Denoise, if it is installed. It is loaded at run time, because Debian does not package it. The
// interfaces of versions 1 and 2 are supported.
#pragma once
#include <memory>
#include <string>

#include "image/image.h"

namespace drc {

enum class OidnQuality { High, Balanced, Fast };

// The mode of the denoiser, a trade of quality for time. With prefilter, albedo and normal are denoised first and then
// taken as clean; without, they guide the filter as they are, which is faster. Without prefilter, version 2.5 uses the
// same filter for high and balanced on a CPU, bit for bit.
struct OidnSettings {
    OidnQuality quality = OidnQuality::High;
    bool prefilter = true;

    bool operator==(const OidnSettings&) const = default;
};

class OpenImageDenoise {
  public:
    // library: a file; if empty, the usual names are looked up as the system does. Throws Error that says what is
    // missing and where to get it.
    explicit OpenImageDenoise(const std::string& library);
    ~OpenImageDenoise();
    OpenImageDenoise(const OpenImageDenoise&) = delete;
    OpenImageDenoise& operator=(const OpenImageDenoise&) = delete;

    // Denoises a picture (RGB, linear radiance). albedo and normal: three channels each, of the first surface that is
    // neither a mirror nor smooth glass; zero where there is none. All images have one size. Uses as many threads as
    // parallel loops do. A library older than the wanted quality (balanced: 2.0, fast: 2.3) uses the next better one
    // that it knows, and a warning says so. Throws Error if the library fails.
    Image denoised(const Image& color, const Image& albedo, const Image& normal,
                   const OidnSettings& settings = {}) const;

    // The library's version: 10000 major + 100 minor + patch.
    int version() const;

  private:
    struct Library;
    std::unique_ptr<Library> library_;
};

}  // namespace drc
