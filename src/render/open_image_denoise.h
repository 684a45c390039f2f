// Intel's Open Image Denoise, if the machine has it: loaded when it is asked for, since Debian does not package it.
// Both of its interfaces are understood, that of versions 1 and 2.
#pragma once
#include <memory>
#include <string>

#include "image/image.h"

namespace drc {

class OpenImageDenoise {
  public:
    // library: a file, or empty: what the system finds by its usual names. Throws Error that says what is missing and
    // where to get it.
    explicit OpenImageDenoise(const std::string& library);
    ~OpenImageDenoise();
    OpenImageDenoise(const OpenImageDenoise&) = delete;
    OpenImageDenoise& operator=(const OpenImageDenoise&) = delete;

    // The picture (RGB, linear radiance) without noise. Albedo and normal (RGB each, of the first surface that is no
    // mirror or glass; zero where there is none) may be noisy: they are filtered first. All of the same size. On as
    // many threads as loops use. Throws Error if the library fails.
    Image denoised(const Image& color, const Image& albedo, const Image& normal) const;

  private:
    struct Library;
    std::unique_ptr<Library> library_;
};

}  // namespace drc
