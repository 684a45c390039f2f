// Intel's Open Image Denoise, loaded at run time (oidn_library.h). The interfaces of versions 1 and 2 are supported.
#pragma once
#include <memory>
#include <string>

#include "base/parallel.h"
#include "image/image.h"
#include "reconstruct/oidn_library.h"

namespace drc {

enum class OidnQuality { High, Balanced, Fast };

// How albedo and normal guide the denoiser. Raw: as they are. Clean: as they are, declared free of noise, which keeps
// more detail, but also any noise in them. Prefiltered: denoised first and then declared free of noise, which takes
// longest.
enum class OidnAuxiliaries { Raw, Clean, Prefiltered };

// The mode of the denoiser, a trade of quality for time. With raw auxiliaries, version 2.5 uses the same filter for
// high and balanced on a CPU, bit for bit; otherwise high takes twice the time of balanced.
struct OidnSettings {
    OidnQuality quality = OidnQuality::High;
    OidnAuxiliaries auxiliaries = OidnAuxiliaries::Prefiltered;

    bool operator==(const OidnSettings&) const = default;
};

class OpenImageDenoise {
  public:
    // Loads the first of the libraries that can be used here. Throws Error if none can: it says what is wrong with a
    // library that was named, or that none was found and how to get one.
    explicit OpenImageDenoise(const OidnLibraries& libraries);
    ~OpenImageDenoise();
    OpenImageDenoise(const OpenImageDenoise&) = delete;
    OpenImageDenoise& operator=(const OpenImageDenoise&) = delete;

    // Denoises a picture (RGB, linear radiance) in place. albedo and normal: three channels each, of the first surface
    // that is neither a mirror nor smooth glass; zero where there is no surface. They may be empty images; the library
    // uses no normals without albedo. All other images have the same size. Uses as many threads as parallel loops do. A
    // library older than the wanted quality (balanced: 2.0, fast: 2.3) uses the next better one that it supports, with
    // a warning. After `cancel` is raised, the call ends as soon as the library lets it, and the contents of color are
    // of no use. Throws Error if the library fails.
    void denoise(Image& color, const Image& albedo, const Image& normal, const OidnSettings& settings = {},
                 const CancelToken* cancel = nullptr) const;

    // The library's version: 10000 major + 100 minor + patch.
    int version() const;
    // The file that the library was loaded from.
    const std::string& file() const;

  private:
    struct Library;
    std::unique_ptr<Library> library_;
};

}  // namespace drc
