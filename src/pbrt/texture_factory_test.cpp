#include "pbrt/texture_factory.h"

#include <gmock/gmock.h>

#include "base/log.h"
#include "image/color.h"
#include "image/image_io.h"
#include "pbrt/param_parser.h"
#include "pbrt/test_scenes.h"
#include "scene/textures/noise.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

class TextureFactoryTest : public testing::Test {
  protected:
    template <typename Make>
    auto request(const std::string& params, const Transform& ctm, const Make& make) {
        TokenStream tokens(Source::fromText(params, "t.pbrt", directory_));
        const ParamSet set = parseParams(tokens, "texture 't'", tokens.peek().pos, files_);
        const TextureParams textureParams(set, textures_);
        const auto texture = make(TextureRequest{textureParams, ctm, files_, images_});
        set.warnUnused();
        images_.finish();
        return texture;
    }
    // A float texture of pbrt's given type, from parameters in the syntax of the file.
    FloatTexturePtr number(const std::string& type, const std::string& params = "", const Transform& ctm = {}) {
        return request(params, ctm, [&](const TextureRequest& r) { return makeFloatTexture(type, r); });
    }
    RgbTexturePtr color(const std::string& type, const std::string& params = "", const Transform& ctm = {}) {
        return request(params, ctm, [&](const TextureRequest& r) { return makeRgbTexture(type, r); });
    }
    static TextureContext at(const Vec2& uv, const Vec3& p = Vec3(0.f)) {
        TextureContext context;
        context.uv = uv;
        context.p = p;
        return context;
    }

    NamedTextures textures_;
    std::string directory_ = ".";  // of the file that contains the parameters
    FileSearch files_{directory_};
    TextureFiles images_;
};

TEST_F(TextureFactoryTest, DefaultsArePbrts) {
    forgetWarnings();
    EXPECT_EQ(number("constant")->eval(at(Vec2(0, 0))), 1);
    EXPECT_EQ(number("scale")->eval(at(Vec2(0, 0))), 1);
    EXPECT_EQ(number("mix")->eval(at(Vec2(0, 0))), 0.5f);
    EXPECT_EQ(color("checkerboard")->eval(at(Vec2(0.5f, 0.5f))), Rgb(1.f));
    EXPECT_EQ(color("checkerboard")->eval(at(Vec2(1.5f, 0.5f))), Rgb(0.f));
    EXPECT_EQ(number("bilerp")->eval(at(Vec2(0.3f, 0.25f))), 0.25f);
    EXPECT_EQ(color("bilerp")->eval(at(Vec2(0.3f, 0.25f))), Rgb(0.25f));
    EXPECT_EQ(color("uv")->eval(at(Vec2(0.3f, 0.25f))), Rgb(0.3f, 0.25f, 0));
    const Vec3 p(0.3f, 0.4f, 0.2f), none(0.f);
    EXPECT_EQ(number("fbm")->eval(at(Vec2(0, 0), p)), fbm(p, none, none, {8, 0.5f}));
    EXPECT_EQ(number("wrinkled")->eval(at(Vec2(0, 0), p)), turbulence(p, none, none, {8, 0.5f}));
    EXPECT_EQ(color("windy")->eval(at(Vec2(0, 0), p)), Rgb(number("windy")->eval(at(Vec2(0, 0), p))));
    EXPECT_NEAR(color("marble")->eval(at(Vec2(0, 0), Vec3(0, -kPi / 2 + 0.01f, 0))).z, 0.9f, 0.02f);
    EXPECT_EQ(warningCount(), 0);
}

TEST_F(TextureFactoryTest, Parameters) {
    forgetWarnings();
    const Vec3 p(0.3f, 0.4f, 0.2f), none(0.f);
    EXPECT_EQ(number("fbm", "\"integer octaves\" 3 \"float roughness\" .7")->eval(at(Vec2(0, 0), p)),
              fbm(p, none, none, {3, 0.7f}));
    const auto dots = color("dots", R"("rgb inside" [1 0 0] "rgb outside" [0 0 1] "float uscale" 8 "float vscale" 8)");
    Rgb mean(0.f);
    for (int i = 0; i < 4096; ++i) mean += dots->eval(at(Vec2(float(i % 64) / 64, float(i / 64) / 64))) * (1 / 4096.f);
    EXPECT_NEAR(mean.x + mean.z, 1, 1e-4f);
    // As in both versions of pbrt, "inside" is the colour around the dots.
    EXPECT_GT(mean.z, 0.05f);
    EXPECT_GT(mean.x, 0.5f);
    const auto board = number("checkerboard", R"("integer dimension" 3 "float tex1" 2 "float tex2" 3)");
    EXPECT_EQ(board->eval(at(Vec2(0, 0), Vec3(0.5f, 0.5f, 0.5f))), 2);
    EXPECT_EQ(board->eval(at(Vec2(0, 0), Vec3(0.5f, 0.5f, -0.5f))), 3);
    EXPECT_EQ(number("bilerp", R"("float v00" 1 "float v01" 1 "float v10" 3 "float v11" 3)")->eval(at(Vec2(0.5f, 9))),
              2);
    EXPECT_EQ(color("marble", R"("float variation" 0 "float scale" 2 "integer octaves" 2)")
                  ->eval(at(Vec2(0, 0), Vec3(7, -kPi / 4, 5)))
                  .z,
              0.6f * 1.5f);
    EXPECT_EQ(warningCount(), 0);
}

TEST_F(TextureFactoryTest, AntialiasingOfTheCheckerboard) {
    TextureContext wide = at(Vec2(0.9f, 0.5f));
    wide.duvdx = Vec2(10, 0);
    wide.duvdy = Vec2(0, 10);
    EXPECT_EQ(number("checkerboard")->eval(wide), 0.5f);
    EXPECT_EQ(number("checkerboard", "\"string aamode\" \"none\"")->eval(wide), 1);
}

TEST_F(TextureFactoryTest, MappingsInTheSpaceOfTheirDefinition) {
    const Transform ctm = Transform::translate(Vec3(5, 0, 0)) * Transform::scale(2, 2, 2);
    const auto uvOf = [&](const std::string& params, const Vec3& p) {
        return color("uv", params, ctm)->eval(at(Vec2(0.5f, 0.5f), p));
    };
    // The sphere's centre is at x = 5. Along +y, both the polar angle and the azimuth are 90 degrees.
    const Rgb spherical = uvOf("\"string mapping\" \"spherical\"", Vec3(5, 8, 0));
    EXPECT_NEAR(spherical.x, 0.5f, 1e-5f);
    EXPECT_NEAR(spherical.y, 0.25f, 1e-5f);
    const Rgb cylindrical = uvOf("\"string mapping\" \"cylindrical\"", Vec3(5, 3, 4));
    EXPECT_NEAR(cylindrical.x, 0.75f, 1e-5f);
    EXPECT_NEAR(cylindrical.y, 0.8f, 1e-5f);
    // Planes are in world space.
    const Rgb planar = uvOf(R"("string mapping" "planar" "vector v1" [.1 0 0] "vector v2" [0 0 1] "float vdelta" .25)",
                            Vec3(2, 7, 0.5f));
    EXPECT_NEAR(planar.x, 0.2f, 1e-5f);
    EXPECT_NEAR(planar.y, 0.75f, 1e-5f);
    // Solid textures use the transformation itself, not its inverse.
    EXPECT_EQ(number("fbm", "", Transform::scale(3, 3, 3))->eval(at(Vec2(0, 0), Vec3(0.1f, 0.2f, 0.3f))),
              number("fbm")->eval(at(Vec2(0, 0), Transform::scale(3, 3, 3).point(Vec3(0.1f, 0.2f, 0.3f)))));
}

TEST_F(TextureFactoryTest, ParametersOfAnotherMappingAreWarnedOf) {
    forgetWarnings();
    color("uv", "\"string mapping\" \"spherical\" \"float uscale\" 3 \"float vscale\" 3");
    EXPECT_EQ(warningCount(), 2);
}

TEST_F(TextureFactoryTest, ImageMaps) {
    const TemporaryFolder folder;
    Image image(2, 1);
    image.setRgb(0, 0, Rgb(0.2f));
    image.setRgb(1, 0, Rgb(0.8f));
    folder.write("a.png", encodePng(image));
    writeExr(folder.path() + "/a.exr", image);
    directory_ = folder.path();
    files_ = FileSearch(directory_);
    const auto valueAt = [&](float u, const std::string& params, const std::string& name = "a.png") {
        const std::string all = "\"string filename\" \"" + name + "\" " + params;
        const float value = color("imagemap", all)->eval(at(Vec2(u, 0.5f))).y;
        EXPECT_NEAR(number("imagemap", all)->eval(at(Vec2(u, 0.5f))), value, 1e-4f) << all;
        return value;
    };
    // Integers are taken as sRGB and floats as linear, unless the scene says otherwise.
    EXPECT_NEAR(valueAt(0.25f, ""), 0.2f, 5e-3f);
    EXPECT_NEAR(valueAt(0.25f, "\"bool gamma\" \"false\""), srgbEncode(0.2f), 5e-3f);
    EXPECT_NEAR(valueAt(0.25f, "", "a.exr"), 0.2f, 1e-4f);
    EXPECT_NEAR(valueAt(0.25f, "\"bool gamma\" \"true\"", "a.exr"), srgbDecode(0.2f), 1e-4f);
    EXPECT_NEAR(valueAt(0.75f, "\"float scale\" 2", "a.exr"), 1.6f, 1e-4f);
    EXPECT_NEAR(valueAt(0.375f, "\"float uscale\" 2", "a.exr"), 0.8f, 1e-4f);
    EXPECT_NEAR(valueAt(1.25f, "", "a.exr"), 0.2f, 1e-4f);
    EXPECT_NEAR(valueAt(1.25f, "\"string wrap\" \"clamp\"", "a.exr"), 0.8f, 1e-4f);
    EXPECT_EQ(valueAt(1.25f, "\"string wrap\" \"black\"", "a.exr"), 0);

    const auto errorFor = [&](const std::string& params) { return errorOf([&] { valueAt(0, params); }); };
    EXPECT_THAT(errorFor("\"string wrap\" \"repaet\""),
                HasSubstr("unknown wrap mode 'repaet'; did you mean 'repeat'?"));
    forgetWarnings();
    EXPECT_NEAR(valueAt(0.25f, "\"float maxanisotropy\" 1e30"), 0.2f, 5e-3f);
    EXPECT_EQ(warningCount(), 1);
    EXPECT_THAT(errorFor("\"float maxanisotropy\" 0"), HasSubstr("'maxanisotropy' of texture 't' must be at least 1"));
    EXPECT_THAT(errorOf([&] { color("imagemap"); }), HasSubstr("texture 't' needs the parameter \"string filename\""));
}

TEST_F(TextureFactoryTest, ConstantsFold) {
    textures_.scalars.set("half", constantTexture(0.5f));
    textures_.colors.set("red", constantTexture(Rgb(1, 0, 0)));
    EXPECT_TRUE(number("mix", R"("float tex1" 2 "float tex2" 4 "texture amount" "half")")->isConstant());
    const auto scaled = color("scale", R"("texture tex1" "red" "rgb tex2" [.5 1 1])");
    EXPECT_TRUE(scaled->isConstant());
    EXPECT_EQ(scaled->eval({}), Rgb(0.5f, 0, 0));
}

TEST_F(TextureFactoryTest, Errors) {
    textures_.scalars.set("half", constantTexture(0.5f));
    const auto errorOfColor = [&](const std::string& type, const std::string& params) {
        return errorOf([&] { color(type, params); });
    };
    EXPECT_THAT(errorOfColor("uv", "\"string mapping\" \"sphericl\""),
                HasSubstr("unknown texture mapping 'sphericl'; did you mean 'spherical'?"));
    EXPECT_THAT(errorOfColor("checkerboard", "\"integer dimension\" 4"), HasSubstr("dimension 2 or 3, not 4"));
    EXPECT_THAT(errorOfColor("checkerboard", "\"string aamode\" \"closefrom\""),
                HasSubstr("unknown antialiasing mode 'closefrom'; did you mean 'closedform'?"));
    EXPECT_THAT(errorOfColor("fbm", "\"integer octaves\" 0"),
                HasSubstr("texture 't' must have 1 to 64 octaves, not 0"));
    EXPECT_THAT(errorOfColor("uv", "\"string mapping\" \"planar\" \"vector v1\" [1 0 0 0 1 0]"),
                HasSubstr("'v1' of texture 't' must have one value of type 'vector3', not 2"));
    const auto warningsOfColor = [&](const std::string& type, const std::string& params) {
        return saidBy([&] { color(type, params); });
    };
    EXPECT_EQ(
        warningsOfColor("scale", "\"texture tex1\" \"half\""),
        "drc: t.pbrt:1:16: warning: no spectrum texture 'half' has been defined; the default of 'tex1' of texture 't' "
        "counts; the texture of that name has the other type\n");
    EXPECT_THAT(warningsOfColor("scale", "\"texture tex1\" \"gone\""), HasSubstr("no spectrum texture 'gone'"));
    EXPECT_THAT(warningsOfColor("mix", "\"rgb amount\" [1 1 1]"), HasSubstr("'amount' of texture 't' must be of type"));
    EXPECT_EQ(warningsOfColor("scale", "\"texture tex1\" \"\""), "") << "no texture";
    EXPECT_THAT(errorOf([&] { number("marble"); }),
                HasSubstr("texture 't' must be of type 'spectrum': 'marble' gives colours, not numbers"));
    EXPECT_THAT(errorOf([&] { number("uv"); }), HasSubstr("must be of type 'spectrum'"));
    EXPECT_THAT(errorOfColor("bumpy", ""), HasSubstr("unknown texture 'bumpy'"));
}

}  // namespace
}  // namespace drc::pbrt
