// The meshes of a SceneListing as PLY files.
#pragma once
#include <string>
#include <vector>

#include "pbrt/scene_listing.h"
#include "scene/shapes/shape.h"

namespace drc::pbrt {

// Describes a mesh file, so that readers of the scene need not open it.
struct MeshFile {
    std::string path;  // absolute; empty for shapes that are not meshes
    size_t vertices = 0, triangles = 0;
    bool hasNormals = false, hasUvs = false;
    Bounds bounds;
};

// Absolute paths FOLDER/0.ply, 1.ply, ... by the index of the shape; empty for shapes that are not meshes.
std::vector<std::string> meshPaths(const SceneListing& listing, const std::string& folder);

// Writes the meshes to meshPaths(), and returns one entry for each shape. Vertices are in the file's world space, or in
// the object's space for shapes of objects, or in the shape's own space if it moves. Creates the folder. Throws Error
// if something cannot be written.
std::vector<MeshFile> writeMeshFiles(const SceneListing& listing, const std::string& folder);

// The mesh, moved by offset, with triangles wound so that (p1 - p0) x (p2 - p0) points along the geometric normal. A
// mesh without texture coordinates gets pbrt's if a triangle is turned about, because pbrt gives them to corners by
// their order.
TriangleMesh woundAlongNormals(TriangleMesh mesh, const Vec3& offset);

}  // namespace drc::pbrt
