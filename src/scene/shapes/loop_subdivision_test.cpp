#include "scene/shapes/loop_subdivision.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

struct ControlMesh {
    std::vector<Vec3> positions;
    std::vector<uint32_t> indices;
    TriangleMesh subdivided(int levels) const { return subdivideLoop(positions, indices, levels); }
};

// Counter-clockwise as seen from outside; every vertex has four neighbours.
ControlMesh octahedron() {
    return {{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)},
            {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5}};
}

// A grid of n x n squares of two triangles over [0, 1]^2, with heights f(x, y).
template <typename F>
ControlMesh grid(uint32_t n, const F& f) {
    ControlMesh mesh;
    for (uint32_t y = 0; y <= n; ++y)
        for (uint32_t x = 0; x <= n; ++x) {
            const float s = float(x) / float(n), t = float(y) / float(n);
            mesh.positions.push_back(Vec3(s, t, f(s, t)));
        }
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 2, d = a + n + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
        }
    return mesh;
}

double totalArea(const TriangleMesh& mesh) {
    double sum = 0;
    for (uint32_t i = 0; i < mesh.triangleCount(); ++i) sum += mesh.area(i);
    return sum;
}

TEST(LoopSubdivision, CountsFollowEuler) {
    for (const int levels : {0, 1, 3}) {
        const TriangleMesh mesh = octahedron().subdivided(levels);
        EXPECT_EQ(mesh.triangleCount(), 8u << (2 * levels));
        EXPECT_EQ(mesh.positions.size(), mesh.triangleCount() / 2 + 2);  // V - E + F = 2
        EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    }
}

TEST(LoopSubdivision, VerticesGoToTheLimitAtOnce) {
    // Each vertex of the octahedron has four neighbours, whose mean is the origin. With gamma = 1 / (4 + 4), it keeps
    // half of its distance, whatever the number of levels.
    for (const int levels : {0, 1, 2, 4}) {
        const TriangleMesh mesh = octahedron().subdivided(levels);
        for (size_t i = 0; i < 6; ++i) {
            const Vec3 control = octahedron().positions[i];
            bool found = false;
            for (const Vec3& p : mesh.positions) found = found || length(p - control * 0.5f) < 1e-6f;
            EXPECT_TRUE(found) << control << " at " << levels;
        }
    }
}

TEST(LoopSubdivision, BoundaryIsACubicSpline) {
    // A corner of the boundary has its limit at (p0 + 4 p1 + p2) / 6, whatever the number of levels.
    const ControlMesh mesh = grid(2, [](float, float) { return 0.f; });
    for (const int levels : {0, 1, 3}) {
        const TriangleMesh fine = mesh.subdivided(levels);
        float nearest = kInfinity;
        for (const Vec3& p : fine.positions) nearest = std::min(nearest, length(p - Vec3(0.5f / 6, 0.5f / 6, 0)));
        EXPECT_LT(nearest, 1e-6f) << levels;
        EXPECT_LT(totalArea(fine), 1);
        EXPECT_GT(totalArea(fine), 0.8);
    }
}

TEST(LoopSubdivision, RegularGridReproducesPlanesAndItsNormals) {
    const ControlMesh mesh = grid(4, [](float x, float y) { return 0.5f * x - 0.25f * y; });
    const TriangleMesh fine = mesh.subdivided(2);
    const Vec3 normal = normalize(Vec3(-0.5f, 0.25f, 1));
    for (size_t i = 0; i < fine.positions.size(); ++i) {
        const Vec3& p = fine.positions[i];
        EXPECT_NEAR(p.z, 0.5f * p.x - 0.25f * p.y, 1e-6);
        // At all vertices, including edges and corners with one, two and three triangles. The normals point against the
        // winding.
        EXPECT_LT(length(fine.normals[i] + normal), 1e-4f) << p;
    }
}

TEST(LoopSubdivision, NormalsAreThoseOfTheFineTriangles) {
    const ControlMesh bumpy = grid(5, [](float x, float y) { return 0.4f * std::sin(5 * x) * std::cos(4 * y); });
    for (const ControlMesh& control : {octahedron(), bumpy}) {
        const TriangleMesh fine = control.subdivided(5);
        std::vector<Vec3> mean(fine.positions.size(), Vec3(0.f));
        TriangleMesh bare = fine;
        bare.normals.clear();
        for (uint32_t t = 0; t < bare.triangleCount(); ++t)
            for (int k = 0; k < 3; ++k) mean[bare.indices[3 * t + k]] += bare.geometricNormal(t) * bare.area(t);
        int wrong = 0;
        for (size_t i = 0; i < mean.size(); ++i) wrong += dot(normalize(mean[i]), fine.normals[i]) > -0.998f;
        EXPECT_LT(wrong, int(mean.size()) / 100);
    }
}

TEST(LoopSubdivision, FansThatShareAVertexAreApart) {
    // Two triangles that touch in one point, and a vertex without triangles.
    const ControlMesh bow{
        {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(-1, -1, 0), Vec3(-1, 1, 0), Vec3(9, 9, 9)},
        {0, 2, 1, 0, 4, 3}};
    const TriangleMesh mesh = bow.subdivided(1);
    EXPECT_EQ(mesh.triangleCount(), 8u);
    EXPECT_EQ(mesh.positions.size(), 12u);
    for (const Vec3& p : mesh.positions) EXPECT_LT(length(p), 2);
}

TEST(LoopSubdivision, SaysWhatIsWrong) {
    const std::vector<Vec3> points(5, Vec3(0.f));
    const auto errorOf = [](const ControlMesh& mesh, int levels) {
        return drc::errorOf([&] { mesh.subdivided(levels); });
    };
    EXPECT_THAT(errorOf({points, {0, 1, 2, 0, 1, 3}}, 1), HasSubstr("the edge between vertices 0 and 1 is in two"));
    EXPECT_THAT(errorOf({points, {0, 1, 1}}, 1), HasSubstr("a triangle has vertex 1 twice"));
    EXPECT_THAT(errorOf(octahedron(), 20),
                HasSubstr("subdividing 8 triangles 20 times makes 8.8e+12, and at most 6.71e+07 are made; use fewer"));
    EXPECT_THAT(errorOf(octahedron(), 2147483647), HasSubstr("use fewer levels"));
}

// A zero limit normal must count as computed. Computing it again at each edge of a vertex would take time proportional
// to the square of the number of edges.
TEST(LoopSubdivision, ManyTrianglesAboutOnePointInOnePlaceAreDoneInTheirTime) {
    constexpr uint32_t kSides = 50'000;  // quadratic time would be minutes
    ControlMesh fan{std::vector<Vec3>(kSides + 1, Vec3(0.f)), {}};
    for (uint32_t i = 0; i < kSides; ++i)
        for (const uint32_t corner : {0u, 1 + i, 1 + (i + 1) % kSides}) fan.indices.push_back(corner);
    EXPECT_EQ(fan.subdivided(0).triangleCount(), kSides);
}

}  // namespace
}  // namespace drc
