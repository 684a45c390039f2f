// Open Image Denoise on a picture: on the whole, or on direct light alone. Needs the picture's G-buffer.
#pragma once
#include "render/open_image_denoise.h"
#include "render/picture_filter.h"

namespace drc {

class OidnPictureFilter final : public PictureFilter {
  public:
    // The library must outlive the filter.
    OidnPictureFilter(const OpenImageDenoise& library, bool directAlone) : library_(library), directAlone_(directAlone) {}
    void apply(LayeredPicture& picture) const override;
    std::string name() const override { return directAlone_ ? "oidn-direct" : "oidn"; }

  private:
    const OpenImageDenoise& library_;
    bool directAlone_;
};

}  // namespace drc
