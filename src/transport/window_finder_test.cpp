#include "transport/window_finder.h"

#include <gtest/gtest.h>

#include "base/parallel.h"
#include "math/rng.h"
#include "math/warp.h"
#include "scene/lights/light.h"
#include "scene/materials/material_matte.h"

namespace drc {
namespace {

// A scene of quads.
struct Room {
    Scene scene;
    Transform placed;

    explicit Room(const Transform& t = {}) : placed(t) {}
    void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        auto mesh = std::make_shared<TriangleMesh>();
        for (const Vec3& p : {a, b, c, d}) mesh->positions.push_back(placed.point(p));
        mesh->indices = {0, 1, 2, 0, 2, 3};
        Primitive primitive;
        primitive.mesh = mesh;
        primitive.material = makeMatte({});
        scene.primitives.push_back(std::move(primitive));
    }
    // A wall at x, from (y0, z0) to (y1, z1), with a hole.
    void wall(float x, float y0, float y1, float z0, float z1, const std::array<float, 4>& hole) {
        const auto part = [&](float a, float b, float c, float d) {
            quad(Vec3(x, a, c), Vec3(x, b, c), Vec3(x, b, d), Vec3(x, a, d));
        };
        const auto [h0, h1, v0, v1] = hole;
        part(y0, h0, z0, z1);
        part(h1, y1, z0, z1);
        part(h0, h1, z0, v0);
        part(h0, h1, v1, z1);
    }
    // Floor, ceiling and walls of a room [0, 5] x [0, 4] x [0, 3], but for those at x = 0 and x = 5.
    void shell() {
        quad(Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(5, 4, 0), Vec3(0, 4, 0));
        quad(Vec3(0, 0, 3), Vec3(5, 0, 3), Vec3(5, 4, 3), Vec3(0, 4, 3));
        quad(Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(5, 0, 3), Vec3(0, 0, 3));
        quad(Vec3(0, 4, 0), Vec3(5, 4, 0), Vec3(5, 4, 3), Vec3(0, 4, 3));
    }
    void closed(float x) { quad(Vec3(x, 0, 0), Vec3(x, 4, 0), Vec3(x, 4, 3), Vec3(x, 0, 3)); }

    std::vector<Ray> views(const Vec3& from) const {
        std::vector<Ray> views;
        for (int i = 0; i < 48 * 48; ++i) {
            Ray ray;
            ray.o = placed.point(from);
            ray.d = sampleUniformSphere(Vec2((float(i / 48) + 0.5f) / 48, (float(i % 48) + 0.5f) / 48));
            views.push_back(ray);
        }
        return views;
    }
    static constexpr Vec3 kMiddle{2.5f, 2, 1.5f};
    std::vector<Portal> windows(const Vec3& from = kMiddle) const { return findWindows(Accel(scene), views(from)); }
    size_t windowsOnto(const Light& sky, const Vec3& from = kMiddle) const {
        return drc::windowsOnto(sky, Accel(scene), views(from)).count();
    }
};

// Expects one of the windows to be this one in the room's own space, at x, and to lead out along `outward`.
void expectWindow(const std::vector<Portal>& found, const Room& room, float x, const std::array<float, 4>& hole,
                  float outward) {
    const Vec3 centre = room.placed.point(Vec3(x, (hole[0] + hole[1]) / 2, (hole[2] + hole[3]) / 2));
    const Vec3 out = normalize(room.placed.vector(Vec3(outward, 0, 0)));
    const float unit = length(room.placed.vector(Vec3(1, 0, 0)));
    const float area = sqr(unit) * (hole[1] - hole[0]) * (hole[3] - hole[2]);
    const bool is = std::ranges::any_of(found, [&](const Portal& window) {
        return length(window.pointAt(Vec2(0.5f, 0.5f)) - centre) < 0.06f * unit &&
               dot(window.outward(), out) > 0.999f && std::abs(window.area() - area) < 0.12f * area;
    });
    EXPECT_TRUE(is) << "x = " << x << ", of " << found.size();
}

const Transform kPlacings[] = {{},
                               Transform::translate(Vec3(30, -20, 7)) * Transform::rotate(33, Vec3(0, 0, 1)),
                               Transform::rotate(50, Vec3(1, 2, 3)) * Transform::scale(0.01f, 0.01f, 0.01f),
                               Transform::scale(100, 100, -100)};

TEST(WindowFinder, FindsAWindowWhereverTheRoomIs) {
    for (const Transform& placing : kPlacings) {
        Room room(placing);
        room.shell();
        room.closed(5);
        room.wall(0, 0, 4, 0, 3, {1, 2.5f, 0.8f, 2});
        const auto found = room.windows();
        ASSERT_EQ(found.size(), 1U);
        expectWindow(found, room, 0, {1, 2.5f, 0.8f, 2}, -1);
    }
}

TEST(WindowFinder, FindsSeveral) {
    Room room;
    room.shell();
    room.wall(5, 0, 4, 0, 3, {0.5f, 1.5f, 1, 2.5f});
    room.wall(0, 0, 4, 0, 3, {2, 3.8f, 0.2f, 2.2f});
    const auto found = room.windows();
    ASSERT_EQ(found.size(), 2U);
    expectWindow(found, room, 5, {0.5f, 1.5f, 1, 2.5f}, 1);
    expectWindow(found, room, 0, {2, 3.8f, 0.2f, 2.2f}, -1);
}

// A side of the room that is open altogether.
TEST(WindowFinder, FindsAnOpenSide) {
    Room room;
    room.shell();
    room.closed(0);
    const auto found = room.windows();
    ASSERT_GE(found.size(), 1U);
    expectWindow(found, room, 5, {0, 4, 0, 3}, 1);
}

// Outside there are ground and another house, from which most rays leave upwards.
TEST(WindowFinder, IsNotMisledByWhatStandsOutside) {
    Room room;
    room.shell();
    room.closed(5);
    room.wall(0, 0, 4, 0, 3, {1, 2.5f, 0.8f, 2});
    room.quad(Vec3(-60, -60, -0.5f), Vec3(-0.3f, -60, -0.5f), Vec3(-0.3f, 60, -0.5f), Vec3(-60, 60, -0.5f));
    room.quad(Vec3(-20, -10, -0.5f), Vec3(-20, 0, -0.5f), Vec3(-20, 0, 6), Vec3(-20, -10, 6));
    const auto found = room.windows();
    ASSERT_EQ(found.size(), 1U);
    expectWindow(found, room, 0, {1, 2.5f, 0.8f, 2}, -1);
}

TEST(WindowFinder, FindsNoneWhereThereAreNone) {
    Room closed;
    closed.shell();
    closed.closed(0);
    closed.closed(5);
    EXPECT_TRUE(closed.windows().empty());
    // A floor under the sky, and nothing at all.
    Room open;
    open.quad(Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(9, 9, 0), Vec3(-9, 9, 0));
    EXPECT_TRUE(open.windows().empty());
    EXPECT_TRUE(Room().windows().empty());
}

// A pane of glass hides a window, since light is sampled in straight lines; a surface without a material does not.
TEST(WindowFinder, LooksThroughSurfacesWithoutAMaterial) {
    Room room;
    room.shell();
    room.closed(5);
    room.wall(0, 0, 4, 0, 3, {1, 2.5f, 0.8f, 2});
    room.quad(Vec3(0.01f, 1, 0.8f), Vec3(0.01f, 2.5f, 0.8f), Vec3(0.01f, 2.5f, 2), Vec3(0.01f, 1, 2));
    EXPECT_TRUE(room.windows().empty());
    room.scene.primitives.back().material = nullptr;
    expectWindow(room.windows(), room, 0, {1, 2.5f, 0.8f, 2}, -1);
}

// Beyond the window is a wall, and above the gap between both is the sky. The gap is found, but what comes into the
// room through it comes aslant, and the sky lights the wall from elsewhere, too.
TEST(WindowFinder, KeepsWhatHelps) {
    const LightPtr sky = makeInfiniteLight(Transform(), Rgb(2.f));
    Room room;
    room.shell();
    room.closed(5);
    room.wall(0, 0, 4, 0, 3, {1, 2.5f, 0.8f, 2});
    EXPECT_EQ(room.windowsOnto(*sky), 1U);
    room.quad(Vec3(-1, -1, -1), Vec3(-1, 5, -1), Vec3(-1, 5, 2.6f), Vec3(-1, -1, 2.6f));
    room.quad(Vec3(-8, -5, -0.1f), Vec3(0, -5, -0.1f), Vec3(0, 9, -0.1f), Vec3(-8, 9, -0.1f));
    const Vec3 atTheWindow(0.5f, 1.75f, 1.4f);
    EXPECT_EQ(room.windows(atTheWindow).size(), 1U);
    EXPECT_EQ(room.windowsOnto(*sky, atTheWindow), 0U);
}

// A sun that is much brighter than the sky, of the size of the real one.
TEST(WindowFinder, KeepsAWindowThatTheSunShinesThrough) {
    constexpr int kRows = 1024;
    EnvironmentMap map{2 * kRows, kRows, std::vector<Rgb>(2 * kRows * kRows, Rgb(0.5f))};
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) map.texels[size_t((kRows / 3 + y) * 2 * kRows + kRows + x)] = Rgb(2e4f);
    Room room;
    room.shell();
    room.closed(5);
    room.wall(0, 0, 4, 0, 3, {1, 2.5f, 0.8f, 2});
    // At phi = pi, which is -x, 30 degrees above the horizon.
    EXPECT_EQ(room.windowsOnto(*makeInfiniteLight(Transform(), Rgb(1.f), map)), 1U);
}

TEST(WindowFinder, DoesNotDependOnThreads) {
    Room room;
    room.shell();
    room.closed(5);
    room.wall(0, 0, 4, 0, 3, {1, 2.5f, 0.8f, 2});
    const int threads = threadCount();
    std::vector<Vec3> corners[2];
    for (int i = 0; i < 2; ++i) {
        setThreadCount(i == 0 ? 1 : 4);
        for (const Portal& window : room.windows())
            for (const Vec3& corner : window.corners()) corners[i].push_back(corner);
    }
    setThreadCount(threads);
    EXPECT_EQ(corners[0], corners[1]);
    EXPECT_EQ(corners[0].size(), 4U);
}

}  // namespace
}  // namespace drc
