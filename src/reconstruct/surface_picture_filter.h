// The filter for integrators with map passes: removes the noise of each layer along surfaces, and corrects the maps'
// errors by path-traced samples of the same light (LayerFilter).
#pragma once
#include "reconstruct/picture_filter.h"

namespace drc {

class SurfacePictureFilter final : public PictureFilter {
  public:
    SurfacePictureFilter(bool smooth, bool correct) : smooth_(smooth), correct_(correct) {}
    // picture: from an integrator with map passes.
    void apply(LayeredPicture& picture) const override;
    std::string name() const override { return smooth_ ? "surface" : "correction of the maps"; }

  private:
    bool smooth_, correct_;
};

}  // namespace drc
