// Open Image Denoise, applied to the whole picture or to its direct light alone. Needs the picture's G-buffer.
#pragma once
#include "render/open_image_denoise.h"
#include "render/picture_filter.h"

namespace drc {

class OidnPictureFilter final : public PictureFilter {
  public:
    // The library must outlive the filter.
    OidnPictureFilter(const OpenImageDenoise& library, const OidnSettings& settings, bool directAlone)
        : library_(library), settings_(settings), directAlone_(directAlone) {}
    void apply(LayeredPicture& picture) const override;
    // Denoiser and mode, as "oidn high" or "oidn balanced without prefilter".
    std::string name() const override;

  private:
    const OpenImageDenoise& library_;
    OidnSettings settings_;
    bool directAlone_;
};

}  // namespace drc
