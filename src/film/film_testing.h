// For tests: settings of a film of which a part is rendered.
#pragma once
#include "film/film.h"

namespace drc::test {

inline RenderSettings filmSettings(const PixelRegion& region) {
    RenderSettings settings;
    settings.film = {256, 256};
    settings.pixelBounds = region;
    return settings;
}

}  // namespace drc::test
