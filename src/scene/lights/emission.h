// Emission of a surface: one radiance everywhere, or an image that is looked up by (u, v), as on a screen or a
// stained-glass window; in all directions alike, or by a profile.
#pragma once
#include <memory>
#include <vector>

#include "scene/lights/emission_profile.h"
#include "scene/lights/light_image.h"
#include "scene/textures/texture.h"

namespace drc {

class FacetGrids;

// An image of radiance over the (u, v) of surfaces: interpolated bilinearly, extended beyond its edges or repeated
// there (LightImage::repeats). Row 0 is at v = 0. Surfaces may share it.
class EmissionImage {
  public:
    // The image must not be empty. Pixels that are no numbers are black.
    explicit EmissionImage(LightImage image);
    ~EmissionImage();

    int width() const { return image_.width; }
    int height() const { return image_.height; }
    Rgb lookup(const Vec2& uv) const;
    // Mean of the pixels, of equal weight.
    Rgb mean() const;
    // Mean luminance of the pixels that lookups with low <= (u, v) <= high interpolate. Zero only if all lookups there
    // are black, but for what double precision cannot tell from zero beside the whole image.
    double meanLuminance(const Vec2& low, const Vec2& high) const;

    // Where on flat facets to sample the image.
    FacetGrids& facetGrids() const { return *facetGrids_; }

  private:
    // Sum over the pixels [x0, x1) x [y0, y1).
    double luminanceOf(int x0, int x1, int y0, int y1) const;

    LightImage image_;
    std::vector<double> sums_;  // of the luminance of all pixels before a corner of the image, (width + 1) per row
    std::unique_ptr<FacetGrids> facetGrids_;
};

class Emission {
  public:
    Emission(const Rgb& radiance) : scale_(radiance) {}  // not explicit: a radiance is an emission
    // The image times scale.
    Emission(std::shared_ptr<const EmissionImage> image, const Rgb& scale) : image_(std::move(image)), scale_(scale) {}

    // This emission, distributed over directions by another profile.
    Emission with(const EmissionProfile& profile) const {
        Emission e = *this;
        e.profile_ = profile;
        return e;
    }

    // Radiance, before its profile.
    Rgb at(const Vec2& uv) const { return image_ ? scale_ * image_->lookup(uv) : scale_; }
    const EmissionImage* image() const { return image_.get(); }  // null for one radiance everywhere
    const Rgb& scale() const { return scale_; }
    const EmissionProfile& profile() const { return profile_; }

  private:
    std::shared_ptr<const EmissionImage> image_;
    Rgb scale_;
    EmissionProfile profile_;
};

// The texture's values as radiance. One that varies becomes an image of 512 x 512 pixels over (u, v) in [0,1]^2, which
// repeats; what it does with points in space is lost.
Emission emissionOf(const RgbTexture& texture);

}  // namespace drc
