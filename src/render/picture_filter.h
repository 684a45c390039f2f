// What makes a better picture of the layers of one: denoisers.
#pragma once
#include "render/layered_picture.h"

namespace drc {

class PictureFilter {
  public:
    virtual ~PictureFilter() = default;
    // In place. Takes time in proportion to the number of pixels. Throws Error if a library fails.
    virtual void apply(LayeredPicture& picture) const = 0;
    // As --denoise names it.
    virtual std::string name() const = 0;
};

}  // namespace drc
