#include "render/scene_geometry.h"

#include "scene/cameras/camera_matrices.h"

namespace drc {

FrameGeometry geometryOf(const Scene& scene, const Sensor& sensor) {
    const Camera& camera = *sensor.camera;
    return {worldToCamera(camera, scene.origin), worldToNdc(camera, sensor.settings.film, scene.origin),
            scene.placements.at(camera.shutter().motion(0))};
}

}  // namespace drc
