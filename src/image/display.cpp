#include "image/display.h"

#include <fmt/core.h>

#include "image/auto_exposure.h"

namespace drc {

float exposureOf(const DisplaySettings& settings, const Image& linear) {
    return settings.exposure + (settings.autoExposure ? autoExposure(linear) : 0);
}

std::map<std::string, std::string> displayMetadata(View view, float stops) {
    return {{"drc:display_exposure", fmt::format("{:.4g}", stops)}, {"drc:display_view", viewName(view)}};
}

}  // namespace drc
