// Texture filtering along a path must not reach beyond the surface that the texture is on.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "image/image_io.h"
#include "pipeline.h"

namespace drc {
namespace {

using test::Pipeline;

constexpr float kDark = 0.1f;

// A leaf one unit wide at z = 0 under a sky of radiance one, optionally above a large white floor at z = -2. It shows
// the dark left half of an image whose right half is white.
std::string leafOver(const std::string& picture, bool floor) {
    const auto quad = [](float size, float z) {
        return fmt::format(
            "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" "
            "[{0} {0} {2}  {1} {0} {2}  {1} {1} {2}  {0} {1} {2}] \"float uv\" [0 0 .5 0 .5 1 0 1]\n",
            -size, size, z);
    };
    return "WorldBegin\nLightSource \"infinite\"\nTexture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"" +
           picture + "\"\nMaterial \"matte\" \"texture Kd\" \"t\"\n" + quad(0.5f, 0) +
           (floor ? "Material \"matte\" \"rgb Kd\" [1 1 1]\n" + quad(4, -2) : "") + "WorldEnd\n";
}

std::string writePicture(const TemporaryFolder& folder) {
    Image picture(256, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 256; ++x) picture.setRgb(x, y, Rgb(x < 128 ? kDark : 1.f));
    writeExr(folder.path("half.exr"), picture);
    return folder.path("half.exr");
}

// The leaf seen by a camera in which it is six pixels wide. Under this sky its radiance equals its reflectance.
TEST(TextureWidth, ALeafCutFromAPictureHasItsOwnColour) {
    const TemporaryFolder folder;
    const Pipeline pipeline(leafOver(writePicture(folder), false));
    double sum = 0;
    constexpr int kRays = 20000;
    for (int i = 0; i < kRays; ++i) {
        Sampler sampler(3, uint32_t(i));
        const Vec2 u = sampler.get2D();
        Ray ray;
        ray.o = Vec3(u.x - 0.5f, u.y - 0.5f, 5);
        ray.d = Vec3(0, 0, -1);
        ray.coneSpread = 1 / 6.f / 5;
        sum += double(pipeline.tracer.radiance(ray, sampler).y);
    }
    EXPECT_NEAR(sum / kRays / double(kDark), 1, 0.05);
}

// The light that a floor reflects from the leaf's underside, compared with a leaf of a constant dark colour. Both use
// the same paths.
TEST(TextureWidth, SoHasTheLightThatItReflects) {
    const TemporaryFolder folder;
    const std::string cut = leafOver(writePicture(folder), true);
    std::string plain = cut;
    const std::string textured = "\"texture Kd\" \"t\"";
    plain.replace(plain.find(textured), textured.size(), fmt::format("\"rgb Kd\" [{0} {0} {0}]", kDark));
    const auto fromBelow = [](const std::string& text) {
        const Pipeline pipeline(text);
        double sum = 0;
        constexpr int kPaths = 40000;
        for (int i = 0; i < kPaths; ++i) {
            Sampler sampler(4, uint32_t(i));
            const Vec2 u = sampler.get2D();
            Ray ray;  // to the floor and from there up to the leaf
            ray.o = Vec3(u.x - 0.5f, u.y - 0.5f, -0.5f);
            ray.d = Vec3(0, 0, -1);
            ray.coneSpread = 0.001f;
            PrimaryHit hit;
            if (pipeline.tracer.primaryHit(ray, sampler, hit)) sum += double(pipeline.tracer.indirect(hit, sampler).y);
        }
        return sum / kPaths;
    };
    EXPECT_NEAR(fromBelow(cut) / fromBelow(plain), 1, 0.02);
}

}  // namespace
}  // namespace drc
