#include "pbrt/param_set.h"

#include <gmock/gmock.h>

#include "base/log.h"
#include "pbrt/param_parser.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

class ParamSetTest : public testing::Test {
  protected:
    ParamSet parse(const std::string& text) {
        tokens_ = std::make_unique<TokenStream>(Source::fromText(text, "p.pbrt", "."));
        return parseParams(*tokens_, "material 'matte'", {}, files_);
    }
    std::string errorOfParsing(const std::string& text) {
        return errorOf([&] { parse(text); });
    }

    FileSearch files_{"."};
    std::unique_ptr<TokenStream> tokens_;
};

TEST_F(ParamSetTest, EveryType) {
    const ParamSet p = parse(R"("float f" 1.5 "integer i" [ 7 ] "bool b" "true" "string s" "x y"
                               "point P" [1 2 3] "rgb c" [.1 .2 .3] "texture t" "name" "vector2 v" [1 2 3 4])");
    EXPECT_EQ(p.getFloat("f", 0), 1.5f);
    EXPECT_EQ(p.getInt("i", 0), 7);
    EXPECT_TRUE(p.getBool("b", false));
    EXPECT_EQ(p.getString("s", ""), "x y");
    EXPECT_EQ(p.getPoint("P", Vec3(0, 0, 0)), Vec3(1, 2, 3));
    EXPECT_EQ(p.getColor("c", Rgb(0.f)), Rgb(.1f, .2f, .3f));
    EXPECT_EQ(p.find("t", {ParamType::Texture})->strings[0], "name");
    EXPECT_EQ(p.find("v", {ParamType::Vector2})->count(), 2u);
    EXPECT_EQ(p.unusedCount(), 0u);
    EXPECT_EQ(p.getFloat("absent", 4), 4);
}

TEST_F(ParamSetTest, TheLastOfTwoCounts) { EXPECT_EQ(parse(R"("float f" 1 "float f" 2)").getFloat("f", 0), 2); }

TEST_F(ParamSetTest, UnknownType) {
    EXPECT_EQ(errorOfParsing("\"flaot roughness\" [1]"),
              "p.pbrt:1:1: unknown type 'flaot' of parameter 'roughness' of material 'matte'; did you mean 'float'?\n"
              "    \"flaot roughness\" [1]\n"
              "    ^");
}

TEST_F(ParamSetTest, WrongNumberOfValues) {
    EXPECT_EQ(
        errorOfParsing("\"rgb Kd\" [1 2]"),
        "p.pbrt:1:10: parameter 'Kd' of material 'matte' is of type 'rgb' and takes numbers in groups of 3, found "
        "2\n"
        "    \"rgb Kd\" [1 2]\n"
        "             ^");
    const ParamSet p = parse("\"float sigma\" [1 2]");
    EXPECT_EQ(errorOf([&] { p.getFloat("sigma", 0); }),
              "p.pbrt:1:1: parameter 'sigma' of material 'matte' must have one value of type 'float', not 2\n"
              "    \"float sigma\" [1 2]\n"
              "    ^");
    EXPECT_THAT(errorOf([&] { parse("\"string s\" []").getString("s", ""); }), HasSubstr("type 'string', not 0"));
}

// As a parameter that is not known: a warning, and the default holds.
TEST_F(ParamSetTest, WrongType) {
    const ParamSet p = parse("\"string Kd\" \"red\"");
    Rgb kd(0.f);
    EXPECT_EQ(
        saidBy([&] {
            kd = p.getColor("Kd", Rgb(.25f));
            p.getColor("Kd", Rgb(.25f));
            p.warnUnused();
        }),
        "drc: p.pbrt:1:1: warning: parameter 'Kd' of material 'matte' must be of type 'rgb' (or 'xyz', 'blackbody', "
        "'spectrum'), not 'string'; ignored (said once)\n");
    EXPECT_EQ(kd, Rgb(.25f));
    // What an Attribute sets may be meant for other directives.
    ParamSet own = parse("");
    own.inherit(p);
    EXPECT_EQ(saidBy([&] { own.getColor("Kd", Rgb(.25f)); }), "");
}

TEST_F(ParamSetTest, EmptyNamesAreNone) {
    const ParamSet p = parse("\"texture bump\" \"\" \"string file\" \"\" \"string other\" \"a.png\"");
    EXPECT_EQ(saidBy([&] {
                  EXPECT_EQ(p.find("bump", {ParamType::Texture}), nullptr);
                  EXPECT_EQ(p.getFloat("bump", 3), 3);
                  EXPECT_EQ(p.findFile("file"), nullptr);
              }),
              "");
    EXPECT_EQ(p.needFile("other").strings[0], "a.png");
    EXPECT_THAT(errorOf([&] { p.needFile("file"); }), HasSubstr("parameter 'file' of material 'matte' is empty"));
    EXPECT_THAT(errorOf([&] { p.needFile("none"); }),
                HasSubstr("material 'matte' needs the parameter \"string none\""));
}

// pbrt-v3's own default of a parameter of sppm is the least integer.
TEST_F(ParamSetTest, EndsOfNumberTypes) {
    const ParamSet p = parse(R"("integer least" -2147483648 "integer most" [2147483647] "float big" 3.4028234e38
                               "float low" -3.4028234e38 "float tiny" 1e-45 "float none" 1e-400)");
    EXPECT_EQ(p.getInt("least", 0), std::numeric_limits<int>::min());
    EXPECT_EQ(p.getInt("most", 0), std::numeric_limits<int>::max());
    EXPECT_EQ(p.getFloat("big", 0), std::numeric_limits<float>::max());
    EXPECT_EQ(p.getFloat("low", 0), std::numeric_limits<float>::lowest());
    EXPECT_EQ(p.getFloat("tiny", 0), std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(p.getFloat("none", 1), 0);
    EXPECT_THAT(errorOfParsing("\"float f\" 3.5e38"), HasSubstr("within 3.4e38 of zero"));
}

TEST_F(ParamSetTest, WrongValues) {
    EXPECT_THAT(errorOfParsing("\"float f\" \"x\""), HasSubstr("expected a number for parameter 'f' of type 'float'"));
    EXPECT_THAT(errorOfParsing("\"string f\" 3"), HasSubstr("expected a quoted string for parameter 'f'"));
    EXPECT_THAT(errorOfParsing("\"bool f\" \"yes\""), HasSubstr("expected \"true\" or \"false\""));
    EXPECT_THAT(errorOfParsing("\"bool f\" \"True\""), HasSubstr("found the string \"True\"; write true"));
    EXPECT_THAT(errorOfParsing("\"bool f\" 0"), HasSubstr("found '0'; write false"));
    EXPECT_THAT(errorOfParsing("\"bool f\" \"maybe\""), HasSubstr("found the string \"maybe\"\n"));
    EXPECT_THAT(errorOfParsing("\"integer i\" 1.5"), HasSubstr("takes whole numbers"));
    EXPECT_THAT(errorOfParsing("\"integer i\" 2147483648"), HasSubstr("takes whole numbers from -2^31 to 2^31 - 1"));
    EXPECT_THAT(errorOfParsing("\"integer i\" -2147483649"), HasSubstr("takes whole numbers from -2^31 to 2^31 - 1"));
    EXPECT_THAT(errorOfParsing("\"float\" 3"), HasSubstr("expected a parameter of material 'matte' as \"type name\""));
    EXPECT_THAT(errorOfParsing("\"float f g\" 3"), HasSubstr("expected one type and one name"));
    EXPECT_THAT(errorOfParsing("\"float f\""), HasSubstr("found the end of the file"));
    EXPECT_EQ(errorOfParsing("\"float f\" [1 2"),
              "p.pbrt:1:11: unterminated '[': the file ends before the ']' of parameter 'f' of material 'matte'\n"
              "    \"float f\" [1 2\n"
              "              ^");
}

TEST_F(ParamSetTest, UnusedParametersAreWarnedOfOnce) {
    const ParamSet p = parse("\"float unheardOf\" 1 \"float known\" 2");
    p.getFloat("known", 0);
    forgetWarnings();
    p.warnUnused();
    p.warnUnused();
    EXPECT_EQ(warningCount(), 1);
}

TEST_F(ParamSetTest, SpectraOfEveryKind) {
    const TemporaryFolder folder;
    folder.write("half.spd", "# nm value\n400 0.5\n700 0.5\n");
    files_ = FileSearch(folder.path());
    const ParamSet p = parse(R"("spectrum a" [400 .5 700 .5] "spectrum b" "half.spd" "xyz c" [.5 .5 .5]
                               "blackbody d" [6500 2])");
    const Rgb a = p.getColor("a", Rgb(0.f)), b = p.getColor("b", Rgb(0.f)), c = p.getColor("c", Rgb(0.f));
    EXPECT_EQ(a, b);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], c[i], 2e-3f);
    EXPECT_GT(p.getColor("d", Rgb(0.f)).y, 1);
    const ParamSet q = parse(R"("blackbody one" [3000 1] "blackbody two" [3000 2] "xyz white" [0.950456 1 1.08906]
                               "spectrum many" ["half.spd" "half.spd"] "blackbody many2" [3000 1 3000 2])");
    EXPECT_EQ(q.getColor("two", Rgb(0.f)), q.getColor("one", Rgb(0.f)) * 2.f);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(q.getColor("white", Rgb(0.f))[i], 1, 2e-3f);
    EXPECT_EQ(q.find("many", {ParamType::Color})->colors.size(), 2u);
    EXPECT_EQ(q.find("many2", {ParamType::Color})->colors[1], q.getColor("two", Rgb(0.f)));
    EXPECT_THAT(errorOfParsing("\"spectrum a\" \"absent.spd\""),
                HasSubstr("cannot find the spectrum file 'absent.spd'"));
    EXPECT_THAT(errorOfParsing("\"spectrum a\" [400 1 500]"), HasSubstr("in groups of 2, found 3"));
}

}  // namespace
}  // namespace drc::pbrt
