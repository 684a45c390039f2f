#include "pbrt/mesh_files.h"

#include <filesystem>
#include <utility>

#include "pbrt/ply_writer.h"

namespace drc::pbrt {
namespace {

// Whether the normal that the winding gives is opposite to the geometric normal.
bool isWoundBackwards(const TriangleMesh& mesh, uint32_t triangle) {
    const uint32_t* v = &mesh.indices[3 * size_t(triangle)];
    const auto at = [&](uint32_t vertex) { return Imath::V3d(mesh.positions[vertex]); };
    const Imath::V3d winding = (at(v[1]) - at(v[0])).cross(at(v[2]) - at(v[0]));
    return winding.dot(Imath::V3d(mesh.geometricNormal(triangle))) < 0;
}

// Gives each triangle vertices of its own, with pbrt's default texture coordinates.
TriangleMesh withDefaultUvs(const TriangleMesh& mesh) {
    TriangleMesh result;
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        result.positions.push_back(mesh.positions[mesh.indices[i]]);
        if (!mesh.normals.empty()) result.normals.push_back(mesh.normals[mesh.indices[i]]);
        result.uvs.push_back(mesh.textureCoordinates(uint32_t(i / 3))[i % 3]);
        result.indices.push_back(uint32_t(i));
    }
    return result;
}

MeshFile written(const TriangleMesh& mesh, const std::string& path) {
    MeshFile file{path, mesh.positions.size(), mesh.triangleCount(), !mesh.normals.empty(), !mesh.uvs.empty(), {}};
    for (const Vec3& p : mesh.positions) file.bounds.extend(p);
    writePly(mesh, path);
    return file;
}

}  // namespace

TriangleMesh woundAlongNormals(TriangleMesh mesh, const Vec3& offset) {
    std::vector<uint32_t> turned;
    for (uint32_t triangle = 0; triangle < mesh.triangleCount(); ++triangle)
        if (isWoundBackwards(mesh, triangle)) turned.push_back(triangle);
    if (!turned.empty() && mesh.uvs.empty()) mesh = withDefaultUvs(mesh);
    for (const uint32_t triangle : turned)
        std::swap(mesh.indices[3 * size_t(triangle) + 1], mesh.indices[3 * size_t(triangle) + 2]);
    mesh.flipNormal = false;
    for (Vec3& p : mesh.positions) p += offset;
    return mesh;
}

std::vector<std::string> meshPaths(const SceneListing& listing, const std::string& folder) {
    const std::filesystem::path absolute = std::filesystem::absolute(folder).lexically_normal();
    std::vector<std::string> paths(listing.shapes.size());
    for (size_t i = 0; i < paths.size(); ++i)
        if (listing.shapes[i].mesh) paths[i] = (absolute / (std::to_string(i) + ".ply")).string();
    return paths;
}

std::vector<MeshFile> writeMeshFiles(const SceneListing& listing, const std::string& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) throw Error("cannot make the folder " + folder + ": " + failure.message());
    const std::vector<std::string> paths = meshPaths(listing, folder);
    std::vector<MeshFile> files(paths.size());
    for (size_t i = 0; i < files.size(); ++i) {
        if (paths[i].empty()) continue;
        const ListedShape& shape = listing.shapes[i];
        const bool isInWorld = !shape.object && !shape.toWorld.isAnimated();
        files[i] = written(woundAlongNormals(*shape.mesh, isInWorld ? listing.origin : Vec3(0.f)), paths[i]);
    }
    return files;
}

}  // namespace drc::pbrt
