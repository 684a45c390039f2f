// A floor lit by a single light, for which the outgoing radiance is known: for lights of every type and every
// estimator.
#include <gtest/gtest.h>

#include "pipeline.h"
#include "test_scenes.h"

namespace drc {
namespace {

using test::Estimate;
using test::Pipeline;

// Only the point at the origin is visible.
std::string floorUnder(const std::string& light) {
    return "LookAt 0.4 -1 1.5  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" 0.02\n"
           "Film \"image\" \"integer xresolution\" 2 \"integer yresolution\" 2\nWorldBegin\nAttributeBegin\n"
           "Material \"matte\" \"rgb Kd\" [0 0 0]\n" +
           light + "\nAttributeEnd\nMaterial \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\n" +
           test::quad("-9 -9 0", "9 -9 0", "9 9 0", "-9 9 0") + "WorldEnd\n";
}

// irradiance: at the origin, for a light with an intensity, radiance or (for distant lights) perpendicular irradiance
// of one.
struct LitFloor {
    const char *name, *light;
    double irradiance;
};
void PrintTo(const LitFloor& c, std::ostream* out) { *out << c.name; }

constexpr double kPiD = std::numbers::pi;
const double kSlanted = 2 / (6 * std::sqrt(6.0));  // from (1, -1, 2): cosine over squared distance
// From a square of side 4 at height 2, centred above the origin: four times the form factor of a corner.
const double kSquare = 4 * kPiD * 2 / (2 * kPiD) * (1 / std::sqrt(2.0)) * std::atan(1 / std::sqrt(2.0));
const LitFloor kFloors[] = {
    {"Point", R"(LightSource "point" "point from" [1 -1 2])", kSlanted},
    {"Spot", R"(LightSource "spot" "point from" [1 -1 2] "point to" [0 0 0])", kSlanted},
    {"Goniometric", R"(Translate 1 -1 2 LightSource "goniometric")", kSlanted},
    {"Projection", R"(Translate 0 0 2 Rotate 180 1 0 0 LightSource "projection")", 0.25},
    {"Distant", R"(LightSource "distant" "point from" [1 -1 2] "point to" [0 0 0])", 2 / std::sqrt(6.0)},
    {"Infinite", R"(LightSource "infinite")", kPiD},
    {"InfiniteTurned", R"(Rotate 70 1 2 3 LightSource "infinite")", kPiD},
    {"Disk", R"(AreaLightSource "diffuse" Translate 0 0 2 Rotate 180 1 0 0 Shape "disk")", kPiD / 5},
    {"TwoSidedDisk", R"(AreaLightSource "diffuse" "bool twosided" "true" Translate 0 0 2 Shape "disk")", kPiD / 5},
    {"Sphere", R"(AreaLightSource "diffuse" Translate 0 0 3 Shape "sphere")", kPiD / 9},
    {"Square",
     R"(AreaLightSource "diffuse" Shape "trianglemesh" "integer indices" [0 2 1 0 3 2]
        "point P" [-2 -2 2  2 -2 2  2 2 2  -2 2 2])",
     kSquare},
};

class LitFloors : public testing::TestWithParam<LitFloor> {};
INSTANTIATE_TEST_SUITE_P(Every, LitFloors, testing::ValuesIn(kFloors), [](const auto& i) { return i.param.name; });

TEST_P(LitFloors, ReflectTheIrradianceOfTheBooks) {
    const Pipeline pipeline(floorUnder(GetParam().light));
    const double expected = 0.5 / kPiD * GetParam().irradiance;
    for (const auto way : {&Pipeline::path, &Pipeline::direct}) {
        const Estimate e = pipeline.estimate(way, 4096, 64);
        for (size_t i = 0; i < e.mean.size(); ++i) {
            EXPECT_NEAR(e.mean[i], expected, 4.5 * std::sqrt(e.variance[i]) + 5e-4 * expected);
            EXPECT_LT(std::sqrt(e.variance[i]), 0.02 * expected);
        }
    }
    const Estimate indirect = pipeline.estimate(&Pipeline::tracedIndirect, 64, 1);
    for (const double m : indirect.mean) EXPECT_EQ(m, 0);
}

}  // namespace
}  // namespace drc
