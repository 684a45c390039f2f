// Emission of a surface: a constant radiance, or an image over (u, v) as on a screen or a stained-glass window. The
// radiance is the same in all directions or multiplied by a profile.
#pragma once
#include <memory>
#include <vector>

#include "scene/lights/emission_profile.h"
#include "scene/lights/light_image.h"
#include "scene/textures/texture.h"

namespace drc {

class FacetGrids;

// An image of radiance over a surface's (u, v), interpolated bilinearly. Outside [0, 1]^2 the image repeats, or its
// edge pixels are extended (LightImage::repeats). Row 0 is at v = 0. Several surfaces may share one image.
class EmissionImage {
  public:
    // The image must not be empty. Non-finite pixels become black, negative values zero.
    explicit EmissionImage(LightImage image);
    ~EmissionImage();

    int width() const { return image_.width; }
    int height() const { return image_.height; }
    Rgb lookup(const Vec2& uv) const;
    // Unweighted mean of all pixels.
    Rgb mean() const;
    // Mean luminance of the pixels that lookup() may read for (u, v) in [low, high]. Zero only if all these lookups are
    // black, or so dark that they are lost in rounding: the value is a difference of sums over the image, in doubles.
    double meanLuminance(const Vec2& low, const Vec2& high) const;

    // Tables for sampling the image on flat facets.
    FacetGrids& facetGrids() const { return *facetGrids_; }

  private:
    // Sum of the luminance of the pixels [x0, x1) x [y0, y1).
    double luminanceOf(int x0, int x1, int y0, int y1) const;

    LightImage image_;
    std::vector<double> sums_;  // summed-area table of luminance at pixel corners, (width + 1) per row
    std::unique_ptr<FacetGrids> facetGrids_;
};

class Emission {
  public:
    Emission(const Rgb& radiance) : scale_(radiance) {}  // not explicit: a radiance is an emission
    // The image times scale.
    Emission(std::shared_ptr<const EmissionImage> image, const Rgb& scale) : image_(std::move(image)), scale_(scale) {}

    // A copy of this emission with the given profile.
    Emission with(const EmissionProfile& profile) const {
        Emission e = *this;
        e.profile_ = profile;
        return e;
    }

    // Radiance before multiplication by the profile.
    Rgb at(const Vec2& uv) const { return image_ ? scale_ * image_->lookup(uv) : scale_; }
    const EmissionImage* image() const { return image_.get(); }  // null for one radiance everywhere
    const Rgb& scale() const { return scale_; }
    const EmissionProfile& profile() const { return profile_; }

  private:
    std::shared_ptr<const EmissionImage> image_;
    Rgb scale_;
    EmissionProfile profile_;
};

// Takes the texture's values as radiance. A texture that varies is baked to a repeating image of 512 x 512 pixels over
// (u, v) in [0,1]^2, which loses any dependence on the position in space.
Emission emissionOf(const RgbTexture& texture);

}  // namespace drc
