// Where the surfaces are that the camera itself sees, and what they belong to: the layers Position, Depth, IndexOB and
// IndexMA for compositing and for filters over time. A mirror or a pane of glass is such a surface itself, as with
// Blender's Cycles.
#pragma once
#include "accel/accel.h"
#include "film/film.h"
#include "image/image.h"
#include "transport/g_buffer_sample.h"

namespace drc {

// All images have the size of the film's region.
struct SurfaceLayers {
    Image position;  // X, Y, Z: mean of the points that the pixel's samples meet, world space of the file; else zero
    Image depth;     // Z: of this mean, see surfaceLayersOf(); kNoDepth if no sample meets a surface
    // X: numbers of the object and the material (Scene::placements, Primitive::materialNumber) on the ray through the
    // pixel's centre and the middle of the lens, in the middle of the exposure; 0 if there is none. They do not depend
    // on the samples.
    Image object, material;
};

// The film layer that the points are added to.
inline constexpr const char* kMetLayer = "position";
// extent: radius of the scene, world units; it sets the precision.
void addMetSpec(std::vector<FilmLayerSpec>& layers, float extent);
void addMet(FilmLayer& layer, int x, int y, const GBufferSample& sample);
// Makes the images from that film layer. Depth is z in the camera's space when the shutter opens or, with a camera that
// shows all directions, the distance from it.
SurfaceLayers surfaceLayersOf(const Film& film, const Scene& scene, const Accel& accel, const Camera& camera);

}  // namespace drc
