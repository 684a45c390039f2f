// A scene, as the front ends build it and the integrators see it.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "scene/lights/light.h"
#include "scene/materials/material.h"
#include "scene/media/medium.h"
#include "scene/scene_placements.h"
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
    FloatTexturePtr alpha;                       // for all rays, see alphaIsShare; null: opaque
    FloatTexturePtr shadowAlpha;                 // replaces alpha for shadow rays; null: alpha
    bool alphaIsShare = false;                   // true: alpha is a hit probability (pbrt-v4); false: 0 is a hole
    bool visibleToCamera = true;                 // if not, rays from the camera pass through
    bool visibleToDiffuse = true;                // if not, shadow rays and rays neither fromCamera nor mirrored pass
    uint32_t name = SurfaceNames::kNone;         // row in Scene::names
    uint32_t objectNumber = 0;                   // see Scene::placements; 0: none, or that of the instance
    uint32_t materialNumber = 0;                 // in the order of first use in the file, from 1; 0: none
    MediumInterface media = {};                  // owned by Scene::media
};

// A pbrt object: primitives in object space, to be instanced.
struct ObjectDefinition {
    std::string name;
    std::vector<Primitive> primitives;
};

struct Instance {
    int object = 0;  // index into Scene::objects
    AnimatedTransform objectToWorld;
    uint32_t objectNumber = 0;  // see Scene::placements; 0: that of the primitive
    // Memory for the instance, including its acceleration structure, in bytes.
    double memory() const;
};

struct Scene {
    std::vector<Primitive> primitives;
    std::vector<ObjectDefinition> objects;
    std::vector<Instance> instances;
    std::vector<LightPtr> lights;  // all lights, including those of emissive primitives
    std::vector<std::shared_ptr<const Medium>> media;
    Sensor sensor;  // as the file describes it; a render may use another one
    // Offset subtracted from the file's world coordinates, because floats are finest near zero.
    Vec3 origin{0.f};
    // Where the file's objects are, in the file's world space. An object is a shape of the file,
    // or an instance of several; they are numbered in the file's order, from 1. The numbers are the same in files that
    // differ in transformations, the camera, or parameters alone.
    ScenePlacements placements;
    // Names of the surfaces in the scene file, only for display; may be empty.
    SurfaceNames names;
    // The files from which the scene was read, each once: the scene file first, then the files that it refers to.
    std::vector<std::string> files;

    // Bounds of all primitives over their whole motion.
    Bounds bounds() const;
    size_t triangleCount() const;  // counts the triangles of every instance
};

// Copies a scene with empty space in place of all media, and without names. The copy shares meshes, textures, materials
// and lights; Primitive::name still refers to rows of the original's names.
std::unique_ptr<Scene> withoutMedia(const Scene& scene);

}  // namespace drc
