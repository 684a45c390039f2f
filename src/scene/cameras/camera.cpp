#include "scene/cameras/camera.h"

namespace drc {

std::optional<CameraView> Camera::view(const Vec3&, const Vec2&, float) const { return {}; }
float Camera::pixelsPerArea(const Ray&, float) const { return 0; }

}  // namespace drc
