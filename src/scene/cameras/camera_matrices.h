// A camera's matrices as OpenEXR's standard attributes worldToCamera and worldToNDC define them, at the opening of the
// shutter. Here they act on column vectors, like every Transform (image/exr_matrix.h writes them).
//
// World space is that of the scene file. origin: Scene::origin, the place of the scene's zero in it. Camera space is
// left-handed unless the file mirrors it: x to the right of the picture, y up, z along the view. In NDC space, after
// the division by w, (0, 0) is the upper left corner of the whole film and (1, 1) the lower right one; z has no
// meaning. Source: OpenEXR's documentation, "Standard Optional Attributes".
#pragma once
#include "scene/cameras/camera.h"

namespace drc {

Transform worldToCamera(const Camera& camera, const Vec3& origin);
// None if the camera has no projection by a matrix: Camera::cameraToFilm(). film: the one that the camera was made for.
std::optional<Transform> worldToNdc(const Camera& camera, const FilmGeometry& film, const Vec3& origin);

}  // namespace drc
