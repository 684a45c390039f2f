// Light leaks of final gather: where surfaces are thin, near each other, or lit through a slit, radiance cells must not
// carry light from one side to the other.
#include <gtest/gtest.h>

#include "gathered_pictures.h"
#include "test_scenes.h"

namespace drc {
namespace {

using test::quad;
using test::respelt;

constexpr int kWidth = 48, kHeight = 32;
constexpr double kAllowed = 0.02;
constexpr test::Comparison kComparison{.count = 10, .gatherSpp = 64, .pathSpp = 64};

std::string number(double x) { return std::to_string(x); }

// A box with its faces outwards, without the faces whose letters (x, y, z: the lower ones; X, Y, Z) are in `open`.
std::string box(const Vec3& lo, const Vec3& hi, const std::string& open = "") {
    std::string shapes;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            if (open.find("xyzXYZ"[axis + 3 * upper]) != std::string::npos) continue;
            const int s = (axis + 1) % 3, t = (axis + 2) % 3;
            const auto corner = [&](bool u, bool v) {
                Vec3 p;
                p[axis] = upper ? hi[axis] : lo[axis];
                p[s] = u ? hi[s] : lo[s];
                p[t] = v ? hi[t] : lo[t];
                return number(p.x) + " " + number(p.y) + " " + number(p.z);
            };
            shapes += upper ? quad(corner(false, false), corner(true, false), corner(true, true), corner(false, true))
                            : quad(corner(false, false), corner(false, true), corner(true, true), corner(true, false));
        }
    return shapes;
}

std::string matte(const std::string& rgb) { return "Material \"matte\" \"rgb Kd\" [" + rgb + "]\n"; }

// A lamp that shines downwards, a square of half the side `half` around a point.
std::string lamp(double x, double y, double z, double half, const std::string& light) {
    const auto corner = [&](double dx, double dy) { return number(x + dx) + " " + number(y + dy) + " " + number(z); };
    return "AttributeBegin\n" + matte("0 0 0") + "AreaLightSource \"diffuse\" \"rgb L\" [" + light + "]\n" +
           quad(corner(-half, -half), corner(-half, half), corner(half, half), corner(half, -half)) + "AttributeEnd\n";
}

// A grey room [-2,2]x[-2,2]x[0,3], z up.
std::string room(const std::string& view, const std::string& inside) {
    return "LookAt " + view +
           "  0 0 1\nCamera \"perspective\" \"float fov\" 65\nFilm \"image\" \"integer xresolution\" " +
           std::to_string(kWidth) + " \"integer yresolution\" " + std::to_string(kHeight) +
           "\nIntegrator \"path\" \"integer maxdepth\" 8\nWorldBegin\n" + matte("0.6 0.6 0.6") +
           box(Vec3(-2, -2, 0), Vec3(2, 2, 3)) + inside + "WorldEnd\n";
}

struct LeakCase {
    const char* name;
    std::string text;
};
void PrintTo(const LeakCase& c, std::ostream* out) { *out << c.name; }

// A wall of one millimetre, which ends before the camera: a lamp lights one side, a dim one the other.
std::string thinWall() {
    return room("0.4 -1.9 1.6  0.3 2 1", box(Vec3(0, -0.6f, 0), Vec3(0.001f, 2, 3), "zYZ") +
                                             lamp(-1, 0.8, 2.9, 0.4, "16 14 12") +
                                             lamp(1.2, 0.6, 2.9, 0.4, "1.6 1.6 2"));
}
// A door with a slit of two centimetres under it, a bright panel low behind it, a lamp before it.
std::string slitUnderADoor() {
    const std::string panel = "AttributeBegin\n" + matte("0 0 0") +
                              "AreaLightSource \"diffuse\" \"rgb L\" [60 55 50]\n" +
                              quad("-1 1.9 0", "1 1.9 0", "1 1.9 0.5", "-1 1.9 0.5") + "AttributeEnd\n";
    return room("0 -1.9 1.2  0 1 0.3",
                box(Vec3(-2, 0.8f, 0.02f), Vec3(2, 0.84f, 3), "xXZ") + panel + lamp(0, -0.8, 2.9, 0.4, "6 6 6"));
}
// A cabinet that stands two centimetres from the walls, and a ball on the floor.
std::string contactShadow() {
    return room("0.3 -1.2 1.4  -1.2 1.4 0.3",
                matte("0.7 0.3 0.2") + box(Vec3(-1.98f, 0.9f, 0), Vec3(-0.9f, 1.98f, 0.9f), "z") +
                    matte("0.7 0.7 0.7") +
                    "AttributeBegin\nTranslate -0.6 0.6 0.25\nShape \"sphere\" \"float radius\" 0.25\nAttributeEnd\n" +
                    lamp(0.8, -0.6, 2.9, 0.3, "16 14 12"));
}
// A box without a floor around a strong lamp, its lid five millimetres above the walls.
std::string boxWithAGap() {
    return room("0.9 -1.7 1.3  0 0.6 0.5", matte("0.6 0.6 0.6") + box(Vec3(-0.5f, 0, 0), Vec3(0.5f, 1, 0.8f), "zZ") +
                                               box(Vec3(-0.5f, 0, 0.805f), Vec3(0.5f, 1, 0.81f)) +
                                               lamp(0, 0.5, 0.6, 0.2, "40 36 32") + lamp(0.8, -1.2, 2.9, 0.4, "8 8 8"));
}
// A shade without thickness around a small bright ball, open above and below.
std::string lampShade() {
    return room("0.3 -1.9 1.4  0 0.8 1.1",
                "AttributeBegin\nTranslate 0 0.8 1\n" + matte("0.7 0.65 0.5") +
                    "Shape \"hyperboloid\" \"point p1\" [0.3 0 0] \"point p2\" [0.2 0 0.4]\n" + matte("0 0 0") +
                    "AreaLightSource \"diffuse\" \"rgb L\" [30 26 20]\nTranslate 0 0 0.15\n"
                    "Shape \"sphere\" \"float radius\" 0.15\nAttributeEnd\n" +
                    lamp(0.8, -1.2, 2.9, 0.4, "8 8 8"));
}

class GatherLeaks : public testing::TestWithParam<LeakCase> {};
INSTANTIATE_TEST_SUITE_P(RadianceCells, GatherLeaks,
                         testing::Values(LeakCase{"ThinWall", thinWall()}, LeakCase{"SlitUnderADoor", slitUnderADoor()},
                                         LeakCase{"ContactShadow", contactShadow()},
                                         LeakCase{"BoxWithAGap", boxWithAGap()}, LeakCase{"LampShade", lampShade()}),
                         [](const auto& i) { return i.param.name; });

TEST_P(GatherLeaks, NoBlockIsOffByMoreThanTwoPercent) {
    const auto scene = pbrt::loadPbrtString(GetParam().text);
    const test::Gathered result = test::gather(*scene, kComparison);
    const test::ZResult z = result.differencesBeyond(kAllowed);
    test::record(result);
    EXPECT_LT(z.worst, z.bound) << "a block is off by " << result.worstDifference();
    EXPECT_LT(result.worstError(), kAllowed) << "too noisy to tell";
    EXPECT_GT(result.answered, 0.5) << "the cells are hardly asked";
}

// That the test above can fail: cells of a quarter of the room's width, with samples enough to tell.
TEST(GatherLeaksTest, FindsCellsThatAreTooLarge) {
    const auto scene = pbrt::loadPbrtString(thinWall());
    const test::Comparison comparison{.count = 10, .gatherSpp = 128, .pathSpp = 128, .cellSize = 1};
    const test::Gathered result = test::gather(*scene, comparison);
    test::record(result);
    const test::ZResult z = result.differencesBeyond(kAllowed);
    EXPECT_GT(z.worst, z.bound) << "the worst block is off by " << result.worstDifference();
}

// Beside the thin wall, too, what cells blur falls with their size to zero, be it Lambert's light or that of a rough
// coat: the mean square of the blocks' differences, less what noise adds to it.
TEST(GatherLeaksTest, BiasFallsWithTheSizeOfCellsToZero) {
    const std::string rough =
        "Material \"plastic\" \"rgb Kd\" [.6 .6 .6] \"rgb Ks\" [.4 .4 .4] \"float roughness\" .8\n";
    for (const std::string& material : {matte("0.6 0.6 0.6"), rough}) {
        SCOPED_TRACE(material);
        const auto scene = pbrt::loadPbrtString(respelt(thinWall(), matte("0.6 0.6 0.6"), material));
        test::Comparison comparison{.count = 8, .gatherSpp = 96, .pathSpp = 192};
        const test::PathPictures paths = test::pathPictures(*scene, comparison);
        const auto bias = [&](float cellSize) {
            comparison.cellSize = cellSize;
            return test::gather(*scene, comparison, paths).squaredBias();
        };
        const double coarse = bias(0.5f), medium = bias(0.125f), fine = bias(0.03f);
        EXPECT_GT(coarse, 1.5 * medium);
        EXPECT_GT(medium, 4 * fine);
        EXPECT_LT(fine, 5e-5);
    }
}

}  // namespace
}  // namespace drc
