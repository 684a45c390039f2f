// The interface of denoisers, which work on the layers of a picture.
#pragma once
#include "film/layered_picture.h"

namespace drc {

class PictureFilter {
  public:
    virtual ~PictureFilter() = default;
    // Filters the picture in place, in time proportional to its number of pixels. Throws Error if a library fails.
    virtual void apply(LayeredPicture& picture) const = 0;
    // The name for messages, beginning with the value of --denoise.
    virtual std::string name() const = 0;
};

}  // namespace drc
