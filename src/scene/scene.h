// A scene as the integrators see it: what the front ends build and Accel intersects.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/camera.h"
#include "scene/filter.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/shape.h"
#include "scene/triangle_mesh.h"

namespace drc {

// A mesh or a shape (exactly one is set) with what covers it.
struct Primitive {
    TriangleMeshPtr mesh;
    ShapePtr shape;
    MaterialPtr material;                        // null: pbrt's "none", which light passes through unhindered
    std::shared_ptr<const AreaLight> areaLight;  // null: does not emit. Also listed in Scene::lights
    FloatTexturePtr alpha;                       // 0: a hole, for all rays; null: opaque
    FloatTexturePtr shadowAlpha;                 // the same for shadow rays alone; null: as alpha
};

// What pbrt calls an object: primitives in a space of their own.
struct ObjectDefinition {
    std::string name;
    std::vector<Primitive> primitives;
};

struct Instance {
    int object = 0;  // index into Scene::objects
    AnimatedTransform objectToWorld;
    // Bytes that it takes, with what is made of it for rays.
    double memory() const;
};

// Pixels [x0, x1) x [y0, y1) of the film.
struct PixelRegion {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    size_t count() const { return size_t(width()) * size_t(height()); }
    bool operator==(const PixelRegion&) const = default;
    size_t index(int x, int y) const { return size_t(y - y0) * size_t(width()) + size_t(x - x0); }
};

// Settings of the file, obeyed or overridden by the command line.
struct RenderSettings {
    std::string integrator = "path";  // as the file names it: "path", "directlighting", "iispt", ...
    int maxDepth = 5;
    int samplesPerPixel = 16;
    std::string sampler = "halton";
    std::string outputFile = "pbrt.exr";
    SourceLocation outputFileAt;  // where the file names that, for messages; empty: it does not
    FilmGeometry film;
    SourceLocation filmAt;                   // where the file gives the film's size, for messages; empty: it does not
    float cropWindow[4] = {0, 1, 0, 1};      // as cropWindowOf() gives it (crop_window.h)
    std::optional<PixelRegion> pixelBounds;  // of the film; none: all of it
    // What of the film is rendered: the crop window in whole pixels, by pbrt's rounding, and of it what lies within the
    // pixel bounds; at least one pixel.
    PixelRegion region() const;
    float filmScale = 1;
    float maxSampleLuminance = kInfinity;
    FilterPtr filter;  // never null
};

struct Scene {
    std::vector<Primitive> primitives;
    std::vector<ObjectDefinition> objects;
    std::vector<Instance> instances;
    std::vector<LightPtr> lights;  // all, those of emissive primitives included
    std::unique_ptr<Camera> camera;
    RenderSettings settings;

    // Of everything, wherever it moves.
    Bounds bounds() const;
    size_t triangleCount() const;  // instances counted each
};

}  // namespace drc
