#include "pbrt/mesh_shapes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/limits.h"
#include "pbrt/ply_reader.h"
#include "scene/shapes/height_field.h"
#include "scene/shapes/loop_subdivision.h"

namespace drc::pbrt {
namespace {

// How a mesh is transformed from its own space to world space.
struct Placing {
    explicit Placing(const ShapeContext& context)
        : toWorld(context.objectToWorld), reverse(context.reverseOrientation), dialect(context.dialect) {}
    Transform toWorld;
    bool reverse;
    Dialect dialect;
};

bool isUsable(const Vec3& p) {
    return std::abs(p.x) < limits::kCoordinate && std::abs(p.y) < limits::kCoordinate &&
           std::abs(p.z) < limits::kCoordinate;
}

// Transforms the mesh to world space, with normals oriented as in pbrt.
TriangleMeshPtr placed(TriangleMesh mesh, const Placing& placing) {
    mesh.apply(placing.toWorld);
    if (placing.dialect == Dialect::V3) mesh.bumpTangents = BumpTangents::OppositeUnit;
    if (placing.reverse) {
        mesh.flipNormal = !mesh.flipNormal;
        for (Vec3& normal : mesh.normals) normal = -normal;
    }
    if (!std::ranges::all_of(mesh.positions, isUsable)) {
        // Vertices that no triangle uses may be anywhere, and may even be NaN.
        for (const uint32_t index : mesh.indices)
            if (!isUsable(mesh.positions[index]))
                throw Error("the mesh has a vertex at no number, or farther from the origin than 1e18");
        const Vec3 used = mesh.indices.empty() ? Vec3(0.f) : mesh.positions[mesh.indices[0]];
        std::ranges::replace_if(
            mesh.positions, [](const Vec3& p) { return !isUsable(p); }, used);
    }
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

template <typename V>
std::vector<V> vectors(const Param& param) {
    std::vector<V> result(param.numbers.size() / V::dimensions());
    for (size_t i = 0; i < result.size(); ++i)
        for (unsigned k = 0; k < V::dimensions(); ++k)
            result[i][int(k)] = float(param.numbers[i * V::dimensions() + k]);
    return result;
}

const Param& required(const ParamSet& params, std::string_view name, ParamType type) {
    const Param* param = params.find(name, {type});
    if (param == nullptr || param->count() == 0)
        fail(params.pos(),
             params.owner() + " needs the parameter '" + std::string(name) + "' of type " + describe(type));
    return *param;
}

// Vertex indices, perFace (3 or 4) for each face. With `optional`, a mesh of a single face may omit them (pbrt-v4).
std::vector<uint32_t> readIndices(const ParamSet& params, size_t vertexCount, size_t perFace, bool optional) {
    if (optional && vertexCount == perFace && params.find("indices", {ParamType::Integer}) == nullptr)
        return perFace == 3 ? std::vector<uint32_t>{0, 1, 2} : std::vector<uint32_t>{0, 1, 2, 3};
    const Param& indices = required(params, "indices", ParamType::Integer);
    const size_t n = indices.numbers.size();
    if (n % perFace != 0)
        params.failAt(indices, std::string("must have ") +
                                   (perFace == 3 ? "three values a triangle" : "four values a patch") + ", found " +
                                   std::to_string(n));
    std::vector<uint32_t> result(n);
    for (size_t i = 0; i < n; ++i) {
        const double index = indices.numbers[i];
        if (!(index >= 0 && index < double(vertexCount)))
            params.failAt(indices, "has the vertex " + std::to_string(int64_t(index)) + ", but 'P' has only " +
                                       std::to_string(vertexCount) + " vertices");
        result[i] = uint32_t(index);
    }
    return result;
}

std::vector<Vec2> readUvs(const ParamSet& params, size_t vertexCount) {
    for (const char* name : {"uv", "st"}) {
        const Param* uv = params.find(name, {ParamType::Float, ParamType::Point2, ParamType::Vector2});
        if (uv == nullptr) continue;
        if (uv->numbers.size() / 2 < vertexCount || uv->numbers.size() % 2 != 0)
            params.failAt(*uv, "must have two values a vertex, " + std::to_string(2 * vertexCount) + ", found " +
                                   std::to_string(uv->numbers.size()));
        auto result = vectors<Vec2>(*uv);
        result.resize(vertexCount);
        return result;
    }
    return {};
}

// The vertices with their attributes.
std::shared_ptr<TriangleMesh> readVertices(const ParamSet& params) {
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->positions = vectors<Vec3>(required(params, "P", ParamType::Point3));
    const size_t count = mesh->positions.size();
    mesh->uvs = readUvs(params, count);
    if (const Param* normals = params.find("N", {ParamType::Normal3})) {
        if (normals->count() != count)
            params.failAt(*normals, "must have as many values as 'P', " + std::to_string(count) + ", found " +
                                        std::to_string(normals->count()));
        mesh->normals = vectors<Vec3>(*normals);
    }
    if (const Param* tangents = params.find("S", {ParamType::Vector3})) {
        if (tangents->count() != count)
            params.failAt(*tangents, "must have as many values as 'P', " + std::to_string(count) + ", found " +
                                         std::to_string(tangents->count()));
        mesh->tangents = vectors<Vec3>(*tangents);
    }
    params.ignore({"discarddegenerateUVs", "faceIndices"});
    return mesh;
}

Geometry geometryOf(const ShapeContext& context, std::shared_ptr<TriangleMesh> mesh) {
    Geometry geometry;
    geometry.loadMesh = [mesh, placing = Placing(context)] { return placed(std::move(*mesh), placing); };
    return geometry;
}

// Drops triangles that contain a vertex twice, and are therefore only an edge, with a warning. pbrt-v3 accepts them.
std::vector<uint32_t> withoutEdges(std::vector<uint32_t> indices, const ParamSet& params) {
    size_t kept = 0;
    for (size_t i = 0; i < indices.size(); i += 3) {
        const uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
        if (a == b || b == c || c == a) continue;
        indices[kept] = a, indices[kept + 1] = b, indices[kept + 2] = c;
        kept += 3;
    }
    if (const size_t dropped = (indices.size() - kept) / 3; dropped > 0)
        warn(params.find("indices", {ParamType::Integer})->pos,
             fmt::format("{} of the triangles of {} has the same vertex twice, and is left out", dropped,
                         params.owner()));
    indices.resize(kept);
    return indices;
}

// Gives the corners of bilinear patches, ordered (0,0) (1,0) (0,1) (1,1), their texture coordinates (u, v). Vertices
// shared by several patches are duplicated, because their coordinates differ.
void giveCornersCoordinates(TriangleMesh& mesh, std::vector<uint32_t>& corners) {
    TriangleMesh separate;
    for (size_t i = 0; i < corners.size(); ++i) {
        separate.positions.push_back(mesh.positions[corners[i]]);
        if (!mesh.normals.empty()) separate.normals.push_back(mesh.normals[corners[i]]);
        if (!mesh.tangents.empty()) separate.tangents.push_back(mesh.tangents[corners[i]]);
        separate.uvs.push_back(Vec2(i % 2 == 1 ? 1.f : 0.f, i % 4 >= 2 ? 1.f : 0.f));
        corners[i] = uint32_t(i);
    }
    mesh = std::move(separate);
}

}  // namespace

Geometry triangleMesh(const ShapeContext& context) {
    auto mesh = readVertices(context.params);
    mesh->indices = readIndices(context.params, mesh->positions.size(), 3, context.dialect == Dialect::V4);
    return geometryOf(context, std::move(mesh));
}

// A patch is split along the diagonal from (0,0) to (1,1), which is exact for flat patches.
Geometry bilinearMesh(const ShapeContext& context) {
    const ParamSet& params = context.params;
    auto mesh = readVertices(params);
    std::vector<uint32_t> corners = readIndices(params, mesh->positions.size(), 4, true);
    params.ignore({"emissionfilename"});  // how to sample the patch; its light has its own sampling
    if (mesh->uvs.empty()) giveCornersCoordinates(*mesh, corners);
    mesh->indices.reserve(corners.size() / 4 * 6);
    for (size_t i = 0; i + 3 < corners.size(); i += 4) {
        const uint32_t p00 = corners[i], p10 = corners[i + 1], p01 = corners[i + 2], p11 = corners[i + 3];
        mesh->indices.insert(mesh->indices.end(), {p00, p10, p11, p00, p11, p01});
    }
    return geometryOf(context, std::move(mesh));
}

Geometry plyMesh(const ShapeContext& context) {
    const ParamSet& params = context.params;
    const Param& name = params.needFile("filename");
    if (context.dialect == Dialect::V4) params.notBuilt({"displacement", "displacement.edgelength"});
    Geometry geometry;
    geometry.meshFile = name.strings[0];
    geometry.loadMesh = [path = context.files.find(geometry.meshFile, name.valuePos, "PLY file"),
                         placing = Placing(context)] { return placed(readPly(path), placing); };
    return geometry;
}

Geometry loopSubdivision(const ShapeContext& context) {
    const ParamSet& params = context.params;
    const auto positions =
        std::make_shared<const std::vector<Vec3>>(vectors<Vec3>(required(params, "P", ParamType::Point3)));
    const auto indices = std::make_shared<const std::vector<uint32_t>>(
        withoutEdges(readIndices(params, positions->size(), 3, false), params));
    if (indices->empty()) return {};
    const int levels = params.getInt("levels", params.getInt("nlevels", 3));
    if (levels < 0) fail(params.pos(), "the 'nlevels' of a loopsubdiv must not be negative");
    params.ignore({"scheme"});  // only one scheme exists in pbrt
    return {.loadMesh = [=, placing = Placing(
                                context)] { return placed(subdivideLoop(*positions, *indices, levels), placing); },
            .subdivided = subdividedTriangles(indices->size() / 3, levels)};
}

Geometry heightField(const ShapeContext& context) {
    const ParamSet& params = context.params;
    const double nu = required(params, "nu", ParamType::Integer).numbers[0];
    const double nv = required(params, "nv", ParamType::Integer).numbers[0];
    if (nu < 2 || nv < 2) fail(params.pos(), "'nu' and 'nv' of a heightfield must be at least 2");
    const Param& z = required(params, "Pz", ParamType::Float);
    if (double(z.numbers.size()) != nu * nv)
        params.failAt(z, "must have nu times nv values, " + std::to_string(int64_t(nu * nv)) + ", found " +
                             std::to_string(z.numbers.size()));
    const auto heights = std::make_shared<const std::vector<float>>(z.numbers.begin(), z.numbers.end());
    return {.loadMesh = [=, placing = Placing(context)] {
        return placed(makeHeightField(uint32_t(nu), uint32_t(nv), *heights), placing);
    }};
}

}  // namespace drc::pbrt
