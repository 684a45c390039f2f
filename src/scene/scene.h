// A scene, as the front ends build it and the integrators see it.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "scene/lights/light.h"
#include "scene/materials/material.h"
#include "scene/media/medium.h"
#include "scene/sensor.h"
#include "scene/shapes/shape.h"
#include "scene/shapes/triangle_mesh.h"
#include "scene/surface_names.h"

namespace drc {

// A mesh or a shape (exactly one is set) with its material and light.
struct Primitive {
    TriangleMeshPtr mesh;
    ShapePtr shape;
    MaterialPtr material;                        // null: pbrt's "none"; light passes through unhindered
    std::shared_ptr<const AreaLight> areaLight;  // null if it does not emit; also listed in Scene::lights
    FloatTexturePtr alpha;                       // transparent where 0, for all rays; null: opaque
    FloatTexturePtr shadowAlpha;                 // the same for shadow rays only; null: as alpha
    bool alphaIsShare = false;                   // of the rays that alpha lets hit the surface (pbrt-v4), at random
    bool visibleToCamera = true;                 // if not, rays from the camera pass through
    bool visibleToDiffuse = true;                // if not, shadow rays and all but Camera and Mirrored ones pass
    uint32_t name = SurfaceNames::kNone;         // its row in Scene::names
    MediumInterface media = {};                  // owned by Scene::media
};

// A pbrt object: primitives in their own space, to be instanced.
struct ObjectDefinition {
    std::string name;
    std::vector<Primitive> primitives;
};

struct Instance {
    int object = 0;  // index into Scene::objects
    AnimatedTransform objectToWorld;
    // Memory that the instance takes, its acceleration structure included, in bytes.
    double memory() const;
};

struct Scene {
    std::vector<Primitive> primitives;
    std::vector<ObjectDefinition> objects;
    std::vector<Instance> instances;
    std::vector<LightPtr> lights;  // all lights, including those of emissive primitives
    std::vector<std::shared_ptr<const Medium>> media;
    Sensor sensor;  // the file's own; a render may have another one
    // Offset subtracted from the file's world coordinates, because floats are finest near zero.
    Vec3 origin{0.f};
    // Names that the file gives the surfaces, for those who ask; may be empty.
    SurfaceNames names;
    // The files that it was read from: the one with the scene first, then those that it names, each once.
    std::vector<std::string> files;

    // Bounds of all primitives over their whole motion.
    Bounds bounds() const;
    size_t triangleCount() const;  // counts the triangles of every instance
};

// Copies a scene with empty space in place of all media, and without names. The copy shares meshes, textures, materials
// and lights; its surfaces have the same rows in the names of the scene.
std::unique_ptr<Scene> withoutMedia(const Scene& scene);

}  // namespace drc
