// Open Image Denoise, applied to the whole picture or to its direct light alone. Needs the picture's G-buffer.
#pragma once
#include "reconstruct/open_image_denoise.h"
#include "reconstruct/picture_filter.h"

namespace drc {

class OidnPictureFilter final : public PictureFilter {
  public:
    // settings.auxiliaries apply to every picture; with unlessClean, only to pictures whose albedo and normal are
    // noisy, while those of other pictures are treated as clean. cancel: as in OpenImageDenoise::denoise. Library and
    // token must outlive the filter.
    OidnPictureFilter(const OpenImageDenoise& library, const OidnSettings& settings, bool unlessClean, bool directAlone,
                      const CancelToken* cancel = nullptr)
        : library_(library),
          settings_(settings),
          unlessClean_(unlessClean),
          directAlone_(directAlone),
          cancel_(cancel) {}
    void apply(LayeredPicture& picture) const override;
    // Denoiser and mode, for example "oidn high" or "oidn balanced without prefilter".
    std::string name() const override;
    // The settings for a picture with this G-buffer.
    OidnSettings settingsFor(const GBuffer& gBuffer) const;

  private:
    const OpenImageDenoise& library_;
    OidnSettings settings_;
    bool unlessClean_, directAlone_;
    const CancelToken* cancel_;
};

}  // namespace drc
