// Scenes for surfaces and lights that some rays do not see: a floor, its light, and what stands on it.
#pragma once
#include <string>

namespace drc::test {

inline const std::string kLampAbove =
    "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [4 4 4]\nTranslate 0 0 3\nRotate 180 1 0 0\n"
    "Shape \"disk\" \"float radius\" 1\nAttributeEnd\n";
inline const std::string kSkyAround = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";

// view: a LookAt.
inline std::string floorScene(const std::string& view, const std::string& lights, const std::string& objects,
                              int maxDepth) {
    return "Integrator \"path\" \"integer maxdepth\" " + std::to_string(maxDepth) + "\n" + view +
           "\nCamera \"perspective\" \"float fov\" 50\n"
           "Film \"image\" \"integer xresolution\" 16 \"integer yresolution\" 8\nWorldBegin\n" +
           lights + "Material \"matte\" \"rgb Kd\" [.5 .5 .5]\nShape \"disk\" \"float radius\" 3\n" + objects +
           "WorldEnd\n";
}

}  // namespace drc::test
