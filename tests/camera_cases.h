// The room of test_scenes.h, seen by cameras of every kind.
#pragma once
#include <ostream>
#include <string>

#include "test_scenes.h"

namespace drc::test {

struct CameraCase {
    const char *name, *camera, *film;
};
inline void PrintTo(const CameraCase& c, std::ostream* out) { *out << c.name; }
inline const CameraCase kCameraCases[] = {
    {"ThinLens", "Camera \"perspective\" \"float fov\" 70 \"float lensradius\" 0.2 \"float focaldistance\" 2", ""},
    {"Scaled", "Scale -2 2 2\nLookAt 0 -1.9 1.5  0 0 1  0 0 1\nCamera \"perspective\" \"float fov\" 70", ""},
    {"Orthographic",
     "Camera \"orthographic\" \"float screenwindow\" [-1.5 1.5 -1 1] \"float lensradius\" 0.1 "
     "\"float focaldistance\" 2",
     ""},
    {"OrthographicWithoutALens", "Camera \"orthographic\" \"float screenwindow\" [-1.5 1.5 -1 1]", ""},
    {"Panorama", "Camera \"environment\"", ""},
    {"Moving",
     "ActiveTransform EndTime\nTranslate 0.5 0 0.2\nActiveTransform All\nCamera \"perspective\" \"float fov\" 70", ""},
    {"Cropped", "Camera \"perspective\" \"float fov\" 70", " \"float cropwindow\" [0.25 0.75 0 0.5]"},
};

// width, height: of what is rendered; the film is larger if the case crops it.
inline std::string roomSeenBy(const CameraCase& c, const std::string& material, int width, int height) {
    const int factor = *c.film != 0 ? 2 : 1;
    std::string text =
        respelt(room(material, width * factor, height * factor), "Camera \"perspective\" \"float fov\" 70", c.camera);
    if (std::string(c.camera).find("LookAt") != std::string::npos)
        text = text.substr(text.find("Scale"));  // the camera of this case in place of the room's
    text = respelt(text, "\nIntegrator", std::string(c.film) + "\nIntegrator");
    return "PixelFilter \"gaussian\" \"float xwidth\" 1.5 \"float ywidth\" 1.5\n" + text;
}

}  // namespace drc::test
