// How the picture of a live view's camera lies in space, for pages that move the camera by what people see of it.
#pragma once
#include <array>

#include "scene/scene.h"
#include "view/view_camera.h"

namespace drc {

struct ViewPicture {
    // Perspective: also that of a realistic lens. Parallel: of an orthographic camera. Panorama: of an environment
    // camera.
    enum class Kind { Perspective, Parallel, Panorama } kind = Kind::Perspective;
    // Width of the picture: on the plane at distance 1 along the axis; world units for parallel rays; radians for a
    // panorama.
    float width = 2;
    // For parallel rays only: edges as in ViewLens::window.
    std::array<float, 4> window{-1, 1, -1, 1};
    // Unit vectors in the axes of LookAt(eye, look, up), x to its right: what the picture shows in its middle (of a
    // perspective, the axis of the camera), and the directions towards its right and its top edge.
    Vec3 ahead{0, 0, 1}, right{1, 0, 0}, top{0, 1, 0};

    // The geometry of what the camera, placed as `at` says, shows in a region of its film, measured with the camera's
    // own rays.
    static ViewPicture of(const Camera& camera, const ViewCamera& at, const PixelRegion& region);
};

}  // namespace drc
