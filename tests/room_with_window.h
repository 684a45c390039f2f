// A room that is closed but for one window, as pbrt-v3 text.
#pragma once
#include <string>

#include "test_scenes.h"

namespace drc::test {

// A room that sees the sky through one window. The sky also lights a glossy ball by BSDF samples.
inline std::string roomWithWindow() {
    return "LookAt 0 -1.9 1.5  0 0 1  0 0 1\nCamera \"perspective\" \"float fov\" 70\n"
           "Film \"image\" \"integer xresolution\" 12 \"integer yresolution\" 8\nIntegrator \"path\"\nWorldBegin\n"
           "LightSource \"infinite\" \"rgb L\" [3 4 5]\n"
           "Material \"matte\" \"rgb Kd\" [0.6 0.5 0.4]\n" +
           quad("-2 -2 0", "2 -2 0", "2 2 0", "-2 2 0") + quad("-2 -2 3", "-2 2 3", "2 2 3", "2 -2 3") +
           quad("-2 2 0", "2 2 0", "2 2 3", "-2 2 3") + quad("-2 -2 0", "-2 -2 3", "2 -2 3", "2 -2 0") +
           quad("-2 -2 0", "-2 2 0", "-2 2 3", "-2 -2 3") + quad("2 -2 0", "2 -2 3", "2 -1 3", "2 -1 0") +
           quad("2 0 0", "2 0 3", "2 2 3", "2 2 0") + quad("2 -1 0", "2 -1 1", "2 0 1", "2 0 0") +
           quad("2 -1 2", "2 -1 3", "2 0 3", "2 0 2") +
           "Material \"plastic\" \"rgb Kd\" [0.2 0.2 0.2] \"rgb Ks\" [0.5 0.5 0.5] \"float roughness\" 0.2\n"
           "Translate 0.3 0.3 0.6\nShape \"sphere\" \"float radius\" 0.5\nWorldEnd\n";
}

}  // namespace drc::test
