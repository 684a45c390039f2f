// How a picture is shown: its exposure and its view. Shared by PNG files, `drc image` and live views.
#pragma once
#include <map>
#include <string>

#include "image/view_transform.h"

namespace drc {

struct DisplaySettings {
    float exposure = 0;         // stops; with autoExposure, in addition to it
    bool autoExposure = false;  // auto_exposure.h
    View view = View::Srgb;

    bool operator==(const DisplaySettings&) const = default;
};

// Total exposure in stops: that of the settings plus, with autoExposure, that of the picture. A picture of a series may
// instead be shown with the exposure of another one.
float exposureOf(const DisplaySettings& settings, const Image& linear);

// Metadata that records how a file's picture is displayed or, for an EXR, should be.
std::map<std::string, std::string> displayMetadata(View view, float stops);

}  // namespace drc
