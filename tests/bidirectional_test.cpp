// Bidirectional path tracing must give the same result as path tracing, for every material, light and camera.
#include <gtest/gtest.h>

#include "camera_cases.h"
#include "light_cases.h"
#include "pictures.h"
#include "test_scenes.h"

namespace drc {
namespace {

using test::Estimate;

constexpr int kWidth = 12, kHeight = 8;
constexpr int kPictures = 24;

// pathSpp: larger than spp, since the path-traced picture is the noisier one.
void expectSameAsPaths(const std::string& text, int spp = 32, int pathSpp = 96) {
    const std::string deep = "Integrator \"path\" \"integer maxdepth\" 12\n" + text;
    const auto path = test::pictures(deep, "path", kPictures, pathSpp);
    const auto both = test::pictures(deep, "bdpt", kPictures, spp);
    const Estimate a = test::estimateOf(both), b = test::estimateOf(path);
    const test::ZResult z = test::zTest(a, b);
    EXPECT_EQ(z.tests, kWidth * kHeight / (test::kBlock * test::kBlock) * 3);
    EXPECT_LT(z.worst, z.bound);
    EXPECT_LT(z.meanSquare, 3);
    // A light path contributes to several pixels, so the variance of the mean over the picture is estimated from whole
    // pictures.
    const Estimate ofBoth = test::estimateOfMeans(both), ofPath = test::estimateOfMeans(path);
    const test::ZResult means = test::zTest(ofBoth, ofPath);
    EXPECT_LT(means.worst, means.bound);
    for (size_t c = 0; c < 3; ++c)
        EXPECT_LT(std::sqrt(ofBoth.variance[c] + ofPath.variance[c]), 0.02 * ofPath.mean[c]) << "too noisy to tell";
}

std::string withoutIntegrator(const std::string& text) { return test::respelt(text, "Integrator \"path\"\n", ""); }

class BidirectionalMaterials : public testing::TestWithParam<size_t> {};
INSTANTIATE_TEST_SUITE_P(Paths, BidirectionalMaterials, testing::Range<size_t>(0, test::allMaterials().size()),
                         [](const auto& i) { return test::allMaterials()[i.param].first; });

TEST_P(BidirectionalMaterials, AgreeWithPaths) {
    expectSameAsPaths(withoutIntegrator(test::room(test::allMaterials()[GetParam()].second, kWidth, kHeight)));
}

class BidirectionalMaterialsOfV4 : public testing::TestWithParam<size_t> {};
INSTANTIATE_TEST_SUITE_P(Paths, BidirectionalMaterialsOfV4, testing::Range<size_t>(0, test::materialsOfV4().size()),
                         [](const auto& i) { return test::materialsOfV4()[i.param].first; });

TEST_P(BidirectionalMaterialsOfV4, AgreeWithPaths) {
    expectSameAsPaths(
        test::inWordsOfV4(withoutIntegrator(test::room(test::materialsOfV4()[GetParam()].second, kWidth, kHeight))));
}

class BidirectionalLights : public testing::TestWithParam<test::LightCase> {};
INSTANTIATE_TEST_SUITE_P(Paths, BidirectionalLights, testing::ValuesIn(test::kLightCases),
                         [](const auto& i) { return i.param.name; });

TEST_P(BidirectionalLights, AgreeWithPaths) {
    const TemporaryFolder folder;
    // Without the mirror, because path tracing does not find caustics of a point light.
    const std::string text =
        test::respelt(test::cornerWith(GetParam(), folder, kWidth, kHeight),
                      R"(Material "mirror" "rgb Kr" [0.8 0.8 0.8])", R"(Material "metal" "float roughness" 0.2)");
    const std::string mirror = R"(Material "conductor" "rgb reflectance" [0.8 0.8 0.8])";
    expectSameAsPaths(test::respelt(text, mirror, mirror + R"( "float roughness" 0.2)"));
}

// With shading normals that differ from the geometric normals, light paths and camera paths must agree in brightness.
TEST(Bidirectional, AgreesWithPathsAboutShadingNormals) {
    const std::string floor =
        "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [-1.2 0.6 0.1 1.2 0.6 0.1 1.2 0.9 1.6 "
        "-1.2 0.9 1.6] \"normal N\" [-0.6 -1 0.2  0.6 -1 0.2  0.5 -1 0.6  -0.5 -1 0.6]\n";
    expectSameAsPaths(withoutIntegrator(test::room(
        "Material \"plastic\" \"rgb Kd\" [0.6 0.6 0.5] \"rgb Ks\" [0.3 0.3 0.3] \"float roughness\" 0.2\n" + floor,
        kWidth, kHeight)));
}

// A coarse mesh with smooth shading normals: both must ignore light from below the shading horizon.
TEST(Bidirectional, AgreesWithPathsAboutFacesShadedRound) {
    const std::string octahedron =
        "AttributeBegin\nTranslate 0.3 0.2 1\nShape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3 0 3 4 0 4 1 5 2 "
        "1 "
        "5 3 2 5 4 3 5 1 4] \"point P\" [0 0 .9 .7 0 0 0 .7 0 -.7 0 0 0 -.7 0 0 0 -.9] \"normal N\" [0 0 1 1 0 0 0 1 0 "
        "-1 0 0 0 -1 0 0 0 -1]\nAttributeEnd\n";
    expectSameAsPaths(
        withoutIntegrator(test::room("Material \"matte\" \"rgb Kd\" [0.8 0.7 0.6]\n" + octahedron, kWidth, kHeight)),
        128, 256);
}

// A floor whose normals lean away from the camera, so that it is below their horizon: they are bent for each view, of
// which a light path has another than a camera path.
const std::pair<const char*, const char*> kLeaning[] = {
    {"Matte", R"(Material "matte" "rgb Kd" [0.8 0.7 0.6])"},
    {"Plastic", R"(Material "plastic" "rgb Kd" [0.3 0.4 0.5] "rgb Ks" [0.4 0.4 0.4] "float roughness" 0.1)"},
    {"Metal", R"(Material "metal" "float roughness" 0.1)"},
    {"Mirror", R"(Material "mirror" "rgb Kr" [0.8 0.9 0.8])"},
    {"Translucent", R"(Material "translucent" "rgb Kd" [0.4 0.4 0.3] "rgb Ks" [0.2 0.2 0.2] "float roughness" 0.3
                       "rgb reflect" [0.5 0.5 0.5] "rgb transmit" [0.5 0.5 0.5])"},
    {"UberInPart", R"(Material "uber" "rgb Kd" [0.3 0.2 0.4] "rgb Ks" [0.2 0.2 0.2] "rgb Kr" [0.3 0.3 0.3]
                      "rgb opacity" [0.6 0.7 0.8] "float roughness" 0.2)"},
    {"Bumpy", R"(Texture "waves" "float" "wrinkled" "integer octaves" 3
                 Texture "low" "float" "scale" "texture tex1" "waves" "float tex2" 0.2
                 Material "plastic" "rgb Kd" [0.3 0.4 0.5] "rgb Ks" [0.4 0.4 0.4] "texture bumpmap" "low")"},
};
class BidirectionalLeaningNormals : public testing::TestWithParam<std::pair<const char*, const char*>> {};
INSTANTIATE_TEST_SUITE_P(Paths, BidirectionalLeaningNormals, testing::ValuesIn(kLeaning),
                         [](const auto& i) { return i.param.first; });

TEST_P(BidirectionalLeaningNormals, AgreeWithPaths) {
    std::string text = test::room(GetParam().second + ("\n" + test::leaningFloor()), kWidth, kHeight);
    text = test::respelt(text, "LookAt 0 -1.9 1.5  0 0 1  0 0 1", "LookAt 0 -1.9 0.5  0 0 0.2  0 0 1");
    expectSameAsPaths(withoutIntegrator(text), 64, 192);
}

// Light paths do not meet curves as camera paths do if these turn towards each ray.
class BidirectionalCurves : public testing::TestWithParam<const char*> {
  protected:
    static std::string room(const std::string& material, const std::string& curves) {
        return withoutIntegrator(test::room(material + "\nAttributeBegin\nTranslate 0 -0.2 1.2\n" + curves +
                                                "AttributeEnd\nMaterial \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\n",
                                            kWidth, kHeight));
    }
};
INSTANTIATE_TEST_SUITE_P(Paths, BidirectionalCurves, testing::Values("flat", "ribbon", "cylinder", "tube"),
                         [](const auto& i) { return i.param; });

TEST_P(BidirectionalCurves, AgreeWithPaths) {
    const std::string curves = test::bentCurves(GetParam(), 0.25f);
    expectSameAsPaths(room(R"(Material "matte" "rgb Kd" [0.9 0.8 0.7])", curves));
    expectSameAsPaths(room(R"(Material "hair" "rgb sigma_a" [0.1 0.2 0.3])", curves));
    expectSameAsPaths(room(R"(Material "plastic" "rgb Kd" [0.4 0.4 0.5] "rgb Ks" [0.4 0.4 0.4])", curves));
}

TEST_P(BidirectionalCurves, AgreeWithPathsAboutTheirLight) {
    expectSameAsPaths(room(R"(Material "matte" "rgb Kd" [0.5 0.5 0.5])",
                           "AreaLightSource \"diffuse\" \"rgb L\" [2 3 4] \"bool twosided\" \"true\"\n" +
                               test::bentCurves(GetParam(), 0.25f)));
}

class BidirectionalCameras : public testing::TestWithParam<test::CameraCase> {};
INSTANTIATE_TEST_SUITE_P(Paths, BidirectionalCameras, testing::ValuesIn(test::kCameraCases),
                         [](const auto& i) { return i.param.name; });

TEST_P(BidirectionalCameras, AgreeWithPaths) {
    expectSameAsPaths(
        withoutIntegrator(test::roomSeenBy(GetParam(), R"(Material "matte" "rgb Kd" [0.5 0.6 0.3])", kWidth, kHeight)));
}

}  // namespace
}  // namespace drc
