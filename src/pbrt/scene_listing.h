// A scene file as a list of its directives, with names, files and transformations resolved: for programs that read
// scenes without a reader of pbrt's format (docs/scene-export.md). Set LoadOptions::listing to fill it.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "math/vec.h"
#include "pbrt/dialect.h"
#include "pbrt/graphics_state.h"
#include "scene/shapes/triangle_mesh.h"

namespace drc::pbrt {

// A parameter as the file gives it. Exactly one of numbers, strings and bools is filled, except for a spectrum, which
// may have numbers and names.
struct ListedParam {
    std::string typeName, name;
    SourceLocation at;
    std::vector<double> numbers;       // also of colours: as written, before any conversion
    std::vector<std::string> strings;  // names of files are absolute paths
    std::vector<bool> bools;
    std::vector<Rgb> colors;  // of colours: in linear RGB with sRGB's primaries
    // For type "texture": the textures of this name, by kind, as indices into SceneListing::textures.
    std::optional<size_t> spectrumTexture, floatTexture;
};

struct ListedDirective {
    std::string type, name;  // name: empty if the directive gives none
    SourceLocation at;       // empty for a default that the file does not write
    std::vector<ListedParam> params;
};

// Transformations are to the file's world space, which Scene::origin does not shift; those of an object's shapes are to
// the space of the object, which its instances place in the world.
struct ListedPlaced : ListedDirective {
    TransformSet toWorld;
};

struct ListedTexture : ListedPlaced {
    bool isFloat = false;
};

struct ListedShape : ListedPlaced {
    bool reverseOrientation = false;
    size_t material = 0;
    std::optional<size_t> areaLight, object;
    std::string inside, outside;  // names of media; empty: empty space
    // Set once the scene is finished; null for shapes that are not meshes. It is where Scene has it: in the scene's
    // world space, or in its own space if the shape moves.
    TriangleMeshPtr mesh;
};

struct ListedObject {
    std::string name;
    SourceLocation at;
};

struct ListedInstance {
    SourceLocation at;
    std::optional<size_t> object;  // none if no object has the name, of which the loader warns
    TransformSet toWorld;
};

// Everything is in the order of the file. Indices are into the vectors of the same name.
struct SceneListing {
    DialectFinding dialect;
    std::array<float, 2> transformTimes{0, 1};
    Vec3 origin = Vec3(0.f);  // Scene::origin
    ListedPlaced camera;
    std::string cameraMedium;
    ListedDirective film, filter, sampler, integrator;
    std::vector<ListedDirective> media;
    std::vector<ListedTexture> textures;
    std::vector<ListedDirective> materials;  // the first is the default material
    std::vector<ListedDirective> areaLights;
    std::vector<ListedPlaced> lights;
    std::vector<ListedShape> shapes;
    std::vector<ListedObject> objects;
    std::vector<ListedInstance> instances;
};

}  // namespace drc::pbrt
