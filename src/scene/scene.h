// A scene, as the front ends build it and the integrators see it.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "image/white_balance.h"
#include "scene/cameras/camera.h"
#include "scene/filter.h"
#include "scene/lights/light.h"
#include "scene/materials/material.h"
#include "scene/media/medium.h"
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

// The pixels [x0, x1) x [y0, y1) of the film.
struct PixelRegion {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    size_t count() const { return size_t(width()) * size_t(height()); }
    bool operator==(const PixelRegion&) const = default;
    size_t index(int x, int y) const { return size_t(y - y0) * size_t(width()) + size_t(x - x0); }
};

// Render settings of the scene file, which the command line may override.
struct RenderSettings {
    std::string integrator = "path";  // as named in the file: "path", "directlighting", "iispt", ...
    int maxDepth = 5;
    int samplesPerPixel = 16;
    std::string sampler = "halton";
    std::string outputFile = "pbrt.exr";
    SourceLocation outputFileAt;  // where the file names that, for messages; empty: it does not
    FilmGeometry film;
    SourceLocation filmAt;                   // where the file sets the film's size, for messages; empty if it does not
    float cropWindow[4] = {0, 1, 0, 1};      // as cropWindowOf() gives it (crop_window.h)
    std::optional<PixelRegion> pixelBounds;  // of the film; none: the whole film
    // The region to render: the crop window, rounded to pixels as in pbrt, intersected with the pixel bounds; at least
    // one pixel.
    PixelRegion region() const;
    float filmScale = 1;
    // Whether the camera sees nothing in place of lights at infinity, and the picture says how much of each pixel
    // surfaces cover: its alpha.
    bool transparentFilm = false;
    // Whether EXR files are to have the layers of `drc render --aovs`, as pbrt-v4's film "gbuffer" asks.
    bool auxiliaryLayers = false;
    std::optional<RgbMatrix> whiteBalance;  // of the finished picture
    float maxSampleLuminance = kInfinity;
    FilterPtr filter;  // not null
};

struct Scene {
    std::vector<Primitive> primitives;
    std::vector<ObjectDefinition> objects;
    std::vector<Instance> instances;
    std::vector<LightPtr> lights;          // all lights, including those of emissive primitives
    std::shared_ptr<const Camera> camera;  // may be replaced, not changed
    std::vector<std::shared_ptr<const Medium>> media;
    const Medium* cameraMedium = nullptr;  // that the camera is in; null: empty space
    RenderSettings settings;
    // Offset subtracted from the file's world coordinates, because floats are finest near zero.
    Vec3 origin{0.f};
    // Names that the file gives the surfaces, for those who ask; may be empty.
    SurfaceNames names;
    // The files that it was read from: the one with the scene first, then those that it names, each once.
    std::vector<std::string> files;

    // Bounds of all primitives over their whole motion.
    Bounds bounds() const;
    size_t triangleCount() const;  // counts the triangles of every instance
    // Puts empty space in place of all media. False if there are none.
    bool removeMedia();
};

}  // namespace drc
