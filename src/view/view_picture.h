// The geometry of a live view's picture, by which pages turn movements in the picture into movements of the camera.
#pragma once
#include <array>

#include "scene/scene.h"
#include "view/view_camera.h"

namespace drc {

struct ViewPicture {
    // Perspective: also for a realistic lens. Parallel: for an orthographic camera. Panorama: for an environment
    // camera.
    enum class Kind { Perspective, Parallel, Panorama } kind = Kind::Perspective;
    // Width of the picture. Perspective: on the plane at distance 1 along the axis. Parallel: in world units. Panorama:
    // in radians.
    float width = 2;
    // Parallel only: the edges of the picture, as in ViewLens::window.
    std::array<float, 4> window{-1, 1, -1, 1};
    // Unit vectors in the axes of LookAt(eye, look, up), whose x points to the right: the direction of the picture's
    // middle (for a perspective, the camera's axis), and the directions towards its right and its top edge.
    Vec3 ahead{0, 0, 1}, right{1, 0, 0}, top{0, 1, 0};

    // The geometry of the picture of a camera, placed at `at`, in a region of its film, measured with the camera's own
    // rays.
    static ViewPicture of(const Camera& camera, const ViewCamera& at, const PixelRegion& region);
};

}  // namespace drc
