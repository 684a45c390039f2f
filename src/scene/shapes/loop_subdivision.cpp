#include "scene/shapes/loop_subdivision.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "base/limits.h"
#include "base/memory.h"
#include "scene/tracing_memory.h"

namespace drc {
namespace {

constexpr uint32_t kNone = ~0u;

// Weight of each of the n neighbours of an interior vertex, for a subdivision step (Warren's choice) and for the limit
// position.
float neighbourWeight(uint32_t n) { return n == 3 ? 3 / 16.f : 3 / (8.f * float(n)); }
float limitWeight(uint32_t n) { return 1 / (float(n) + 3 / (8 * neighbourWeight(n))); }
// Weights of the two boundary neighbours of a boundary vertex. The boundary becomes a cubic B-spline.
constexpr float kBoundaryWeight = 1 / 8.f, kBoundaryLimitWeight = 1 / 6.f;

// Triangles as half-edges: the half-edge 3 f + k runs from the k-th corner of triangle f to the next.
struct HalfEdgeMesh {
    std::vector<Vec3> positions;
    std::vector<uint32_t> origin;  // for each half-edge, the vertex where it starts
    std::vector<uint32_t> twin;    // for each half-edge, the opposite one along the same edge; kNone at the boundary

    static uint32_t next(uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static uint32_t previous(uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    uint32_t end(uint32_t h) const { return origin[next(h)]; }
    // The next half-edge that starts at the same vertex: turned() rotates in the sense of the winding, turnedBack()
    // against it. kNone beyond the boundary.
    uint32_t turned(uint32_t h) const { return twin[previous(h)]; }
    uint32_t turnedBack(uint32_t h) const { return twin[h] == kNone ? kNone : next(twin[h]); }
};

std::vector<uint32_t> findTwins(std::span<const uint32_t> indices) {
    // Sorted by their ends rather than hashed, because a file could choose vertices whose hashes collide.
    struct Edge {
        uint64_t ends;
        uint32_t half;
        bool operator<(const Edge& other) const { return ends < other.ends; }
    };
    std::vector<Edge> edges(indices.size());
    const auto key = [](uint32_t from, uint32_t to) { return uint64_t(from) << 32 | to; };
    const auto describe = [](uint32_t a, uint32_t b) {
        return "the edge between vertices " + std::to_string(a) + " and " + std::to_string(b);
    };
    for (uint32_t h = 0; h < indices.size(); ++h) {
        const uint32_t from = indices[h], to = indices[HalfEdgeMesh::next(h)];
        if (from == to) throw Error("a triangle has vertex " + std::to_string(from) + " twice");
        edges[h] = {key(from, to), h};
    }
    std::sort(edges.begin(), edges.end());
    for (size_t i = 1; i < edges.size(); ++i)
        if (edges[i].ends == edges[i - 1].ends)
            throw Error(describe(uint32_t(edges[i].ends >> 32), uint32_t(edges[i].ends)) +
                        " is in two triangles in the same direction; neighbours must be wound alike, and no more than "
                        "two triangles may share an edge");
    std::vector<uint32_t> twin(indices.size(), kNone);
    for (uint32_t h = 0; h < indices.size(); ++h) {
        const Edge wanted{key(indices[HalfEdgeMesh::next(h)], indices[h]), 0};
        const auto found = std::lower_bound(edges.begin(), edges.end(), wanted);
        if (found != edges.end() && found->ends == wanted.ends) twin[h] = found->half;
    }
    return twin;
}

HalfEdgeMesh makeHalfEdges(std::span<const Vec3> positions, std::span<const uint32_t> indices) {
    HalfEdgeMesh mesh;
    mesh.twin = findTwins(indices);
    mesh.origin.assign(indices.size(), kNone);
    // Each fan of triangles around a vertex gets its own copy of the vertex.
    for (uint32_t h = 0; h < indices.size(); ++h) {
        if (mesh.origin[h] != kNone) continue;
        const auto vertex = uint32_t(mesh.positions.size());
        mesh.positions.push_back(positions[indices[h]]);
        for (uint32_t i = h; i != kNone && mesh.origin[i] == kNone; i = mesh.turned(i)) mesh.origin[i] = vertex;
        for (uint32_t i = mesh.turnedBack(h); i != kNone && mesh.origin[i] == kNone; i = mesh.turnedBack(i))
            mesh.origin[i] = vertex;
    }
    return mesh;
}

// Sums of the positions of a vertex's neighbours, for the subdivision rules.
struct Neighbours {
    Vec3 sum{0.f};
    uint32_t count = 0;
    Vec3 boundarySum{0.f};  // sum of the two neighbours along the boundary
    bool boundary = false;

    Vec3 blend(const Vec3& p, float inner, float outer) const {
        return boundary ? p * (1 - 2 * outer) + boundarySum * outer : p * (1 - float(count) * inner) + sum * inner;
    }
};

std::vector<Neighbours> gatherNeighbours(const HalfEdgeMesh& mesh) {
    std::vector<Neighbours> result(mesh.positions.size());
    for (uint32_t h = 0; h < mesh.origin.size(); ++h) {
        const uint32_t a = mesh.origin[h], b = mesh.end(h);
        result[a].sum += mesh.positions[b];
        ++result[a].count;
        if (mesh.twin[h] != kNone) continue;
        result[a].boundarySum += mesh.positions[b];
        result[b].boundarySum += mesh.positions[a];
        result[a].boundary = result[b].boundary = true;
    }
    return result;
}

// Splits triangle f into four. Triangle 4 f + k, k < 3, is at the k-th corner of f; its half-edges run from the corner
// to the middle of the corner's outgoing edge, to the middle of its incoming edge, and back. Triangle 4 f + 3 is in the
// centre and starts at the middle of the first edge.
HalfEdgeMesh refine(const HalfEdgeMesh& mesh) {
    HalfEdgeMesh fine;
    const std::vector<Neighbours> neighbours = gatherNeighbours(mesh);
    for (size_t v = 0; v < neighbours.size(); ++v)
        fine.positions.push_back(
            neighbours[v].blend(mesh.positions[v], neighbourWeight(neighbours[v].count), kBoundaryWeight));
    std::vector<uint32_t> middle(mesh.origin.size());
    for (uint32_t h = 0; h < mesh.origin.size(); ++h) {
        const uint32_t twin = mesh.twin[h];
        if (twin < h) {
            middle[h] = middle[twin];
            continue;
        }
        middle[h] = uint32_t(fine.positions.size());
        const Vec3 ends = mesh.positions[mesh.origin[h]] + mesh.positions[mesh.end(h)];
        const auto opposite = [&](uint32_t half) { return mesh.positions[mesh.origin[HalfEdgeMesh::previous(half)]]; };
        fine.positions.push_back(twin == kNone ? ends * 0.5f
                                               : ends * (3 / 8.f) + (opposite(h) + opposite(twin)) * (1 / 8.f));
    }
    fine.origin.resize(4 * mesh.origin.size());
    fine.twin.resize(4 * mesh.origin.size());
    // A half-edge is split in two: the first half leaves its origin, the second arrives at its end.
    const auto first = [](uint32_t h) { return 3 * (4 * (h / 3) + h % 3); };
    const auto second = [](uint32_t h) { return 3 * (4 * (h / 3) + (h + 1 - h / 3 * 3) % 3) + 2; };
    for (uint32_t h = 0; h < mesh.origin.size(); ++h) {
        const uint32_t twin = mesh.twin[h], corner = first(h), amid = 3 * (4 * (h / 3) + 3) + h % 3;
        fine.origin[corner] = mesh.origin[h];
        fine.origin[corner + 1] = middle[h];
        fine.origin[corner + 2] = middle[HalfEdgeMesh::previous(h)];
        fine.origin[amid] = middle[h];
        fine.twin[first(h)] = twin == kNone ? kNone : second(twin);
        fine.twin[second(h)] = twin == kNone ? kNone : first(twin);
        // In the central triangle, the half-edge that starts at the middle of h runs along the corner triangle at the
        // end of h.
        const uint32_t cut = first(HalfEdgeMesh::next(h)) + 1;
        fine.twin[amid] = cut;
        fine.twin[cut] = amid;
    }
    return fine;
}

// Normal of the limit surface at a vertex, oriented by the winding, not normalised (PBR 3e, section 3.8.2). start: a
// half-edge that starts at the vertex; for a boundary vertex, the first one in the sense of the winding. ring: scratch
// memory.
Vec3 limitNormal(const HalfEdgeMesh& mesh, uint32_t start, bool boundary, std::vector<Vec3>& ring) {
    const Vec3 p = mesh.positions[mesh.origin[start]];
    ring.clear();
    uint32_t h = start, last = start;
    do {
        ring.push_back(mesh.positions[mesh.end(h)] - p);
        last = h;
        h = mesh.turned(h);
    } while (h != kNone && h != start);
    if (!boundary) {
        Vec3 s(0.f), t(0.f);
        for (size_t i = 0; i < ring.size(); ++i) {
            const float angle = 2 * kPi * float(i) / float(ring.size());
            s += ring[i] * std::cos(angle);
            t += ring[i] * std::sin(angle);
        }
        return cross(s, t);
    }
    ring.push_back(mesh.positions[mesh.origin[HalfEdgeMesh::previous(last)]] - p);
    const size_t n = ring.size();
    const Vec3 along = ring[0] - ring[n - 1];
    if (n == 2) return cross(along, ring[0] + ring[1]);
    if (n == 3) return cross(along, ring[1]);
    if (n == 4) return cross(along, (ring[1] + ring[2]) * 2.f - ring[0] - ring[3]);
    const float step = kPi / float(n - 1);
    Vec3 inward = (ring[0] + ring[n - 1]) * -std::sin(step);
    for (size_t i = 1; i + 1 < n; ++i) inward += ring[i] * ((2 - 2 * std::cos(step)) * std::sin(float(i) * step));
    return cross(along, inward);
}

}  // namespace

double subdividedTriangles(size_t triangles, int levels) { return double(triangles) * std::pow(4.0, levels); }

TriangleMesh subdivideLoop(std::span<const Vec3> positions, std::span<const uint32_t> indices, int levels) {
    const double triangles = subdividedTriangles(indices.size() / 3, levels);
    if (triangles > limits::kSubdividedTriangles)
        throw Error(
            fmt::format("subdividing {} triangles {} times makes {:.3g}, and at most {:.3g} are made; use fewer "
                        "levels",
                        indices.size() / 3, levels, triangles, limits::kSubdividedTriangles));
    // The two half-edge meshes and the sums over neighbours take 80 bytes per triangle, less than the final mesh and
    // its acceleration structure, which are claimed here. There are half as many vertices as triangles.
    constexpr double kMesh = 3 * sizeof(uint32_t) + 2 * sizeof(Vec3) / 2.0, kHalfEdges = 6 * sizeof(uint32_t) + 6;
    MemoryClaim memory(triangles * (kMesh + kTracingBytesPerTriangle + kTracingBytesPerVertex / 2),
                       fmt::format("subdividing to {:.3g} triangles", triangles));
    HalfEdgeMesh mesh = makeHalfEdges(positions, indices);
    for (int level = 0; level < levels; ++level) mesh = refine(mesh);
    memory.taken(triangles * kHalfEdges);

    const std::vector<Neighbours> neighbours = gatherNeighbours(mesh);
    TriangleMesh result;
    result.positions.resize(mesh.positions.size());
    for (size_t v = 0; v < neighbours.size(); ++v)
        result.positions[v] =
            neighbours[v].blend(mesh.positions[v], limitWeight(neighbours[v].count), kBoundaryLimitWeight);
    result.normals.resize(mesh.positions.size(), Vec3(0.f));
    std::vector<Vec3> ring;
    std::vector<bool> done(mesh.positions.size());
    for (uint32_t h = 0; h < mesh.origin.size(); ++h) {
        const uint32_t v = mesh.origin[h];
        const bool boundary = neighbours[v].boundary;
        if (done[v] || (boundary && mesh.twin[h] != kNone)) continue;
        done[v] = true;
        result.normals[v] = -normalize(limitNormal(mesh, h, boundary, ring));
    }
    result.indices = std::move(mesh.origin);
    return result;
}

}  // namespace drc
