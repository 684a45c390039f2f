// Denoises picture files by Open Image Denoise, for `drc image denoise`.
#pragma once
#include <optional>
#include <string>

#include "image/picture_file.h"
#include "reconstruct/open_image_denoise.h"

namespace drc {

// Names of layers are empty where the usual ones are to be found.
struct ImageDenoiserOptions {
    std::string layer, albedo, normal;
    std::string quality = "high";  // high, balanced, fast
    std::string prefilter = "on";  // on, off, clean
    std::string library;
};

// The names of these layers in DRC and in Blender's Cycles, in pbrt-v4's gbuffer film, and in other programs.
const std::vector<std::string>& albedoLayerNames();
const std::vector<std::string>& normalLayerNames();

class ImageDenoiser {
  public:
    // Loads the library. Throws Error if there is none.
    explicit ImageDenoiser(ImageDenoiserOptions options);
    // Denoises the layer in place, and says so in the metadata. colours: what is denoised in place of the layer's own
    // colours. Throws Error, naming the file.
    void denoise(PictureFile& picture, std::optional<Image> colours = {}) const;

  private:
    ImageDenoiserOptions options_;
    OpenImageDenoise library_;
};

}  // namespace drc
