// The geometry of a scene, as its pictures tell it.
#pragma once
#include "image/frame_geometry.h"
#include "scene/scene.h"

namespace drc {

// The geometry of the frame that this sensor shows, which may be another one than the scene's own.
FrameGeometry geometryOf(const Scene& scene, const Sensor& sensor);

}  // namespace drc
