#include "app/compare_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/command_testing.h"
#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class CompareCommandTest : public FolderTest {
  protected:
    void SetUp() override {
        Image a(16, 12), b(16, 12);
        for (float& v : a.data()) v = 0.25f;
        for (float& v : b.data()) v = 0.5f;
        writeExr(path("a.exr"), a);
        writeExr(path("b.exr"), b);
        writeExr(path("small.exr"), a.crop(0, 0, 8, 8));
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 16; ++x) {
                b.setRgb(x, y, Rgb((x + y) % 2 ? 0.55f : 0.45f));
                a.setRgb(x, y, Rgb(x % 2 ? 0.55f : 0.45f));
            }
        writeExr(path("seed1.exr"), a);
        writeExr(path("seed2.exr"), b);
        for (float& v : b.data()) v = 0.5f;
        b.at(3, 3, 1) = std::numeric_limits<float>::quiet_NaN();
        writeExr(path("nan.exr"), b);
    }

    // What the command prints.
    static std::string run(const std::vector<std::string>& arguments) {
        return test::outputOf(addCompareCommand, arguments);
    }
};

TEST_F(CompareCommandTest, NoPictureIsReplacedByADifference) {
    const auto complaint = [&](const char* option, const std::string& file) {
        return errorOf([&] { run({"compare", path("a.exr"), path("b.exr"), option, path(file)}); });
    };
    EXPECT_THAT(complaint("--signed-diff", "b.exr"),
                HasSubstr("this is the same file as the picture " + path("b.exr")));
    std::filesystem::create_directory(path("folder.png"));
    EXPECT_THAT(complaint("--diff", "folder.png"), HasSubstr("--diff: cannot write"));
    EXPECT_THAT(complaint("--diff", "none/a.png"), HasSubstr("there is no folder"));
}

TEST_F(CompareCommandTest, Json) {
    const auto json = nlohmann::ordered_json::parse(run({"compare", path("a.exr"), path("b.exr"), "--json"}));
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    EXPECT_THAT(keys, testing::ElementsAre("ssim", "flip", "relmse", "block_relmse", "mse", "l1", "mean_ratio",
                                           "png_kb", "entropy"));
    EXPECT_EQ(json["entropy"].size(), 2u);
    EXPECT_NEAR(json["mse"].get<double>(), 0.0625, 1e-9);
    EXPECT_NEAR(json["l1"].get<double>(), 0.25, 1e-9);
    EXPECT_NEAR(json["relmse"].get<double>(), 0.0625 / 0.0725, 1e-9);
    EXPECT_NEAR(json["block_relmse"].get<double>(), 0.0625 / 0.0725, 1e-9);
    EXPECT_EQ(json["mean_ratio"], nlohmann::json({2.0, 2.0, 2.0}));
    EXPECT_EQ(json["png_kb"].size(), 2u);
    // Too small for SSIM's window.
    const auto small = nlohmann::json::parse(run({"compare", path("small.exr"), path("small.exr"), "--json"}));
    EXPECT_TRUE(small["ssim"].is_null());
    EXPECT_EQ(small["flip"], 0.0);
}

TEST_F(CompareCommandTest, TableAndDifference) {
    const std::string text =
        run({"compare", path("a.exr"), path("b.exr"), "--diff", path("d.png"), "--exposure", "-1"});
    EXPECT_THAT(text, AllOf(HasSubstr("SSIM"), HasSubstr("mean ratio  2.0000 2.0000 2.0000")));
    const Image diff = readImage(path("d.png"));
    EXPECT_EQ(diff.width(), 64);
    const auto byte = [&](int x, int channel) { return diff.at(x, 0, channel) * 255; };
    EXPECT_NEAR(byte(0, 0), 99, 0.01f);    // 0.125 in sRGB
    EXPECT_NEAR(byte(16, 0), 137, 0.01f);  // 0.25
    EXPECT_NEAR(byte(32, 0), 4 * (137 - 99), 3);
    EXPECT_NEAR(byte(48, 0), 4 * (137 - 99), 3);  // brighter: red
    EXPECT_EQ(byte(48, 2), 0);
}

TEST_F(CompareCommandTest, SignedDifference) {
    run({"compare", path("a.exr"), path("b.exr"), "--signed-diff", path("d.exr")});
    writeExr(path("half.exr"), [] {
        Image image(16, 12);
        for (float& v : image.data()) v = 0.5f;
        return image;
    }());
    run({"compare", path("seed1.exr"), path("half.exr"), "--signed-diff", path("e.exr")});
    const Image a = readImage(path("a.exr")), b = readImage(path("b.exr")), d = readImage(path("d.exr"));
    EXPECT_FLOAT_EQ(d.at(5, 5, 1), b.at(5, 5, 1) - a.at(5, 5, 1));
    EXPECT_FLOAT_EQ(readImage(path("e.exr")).at(1, 0, 0), -0.05f);
    EXPECT_EQ(errorOf([&] {
                  run({"compare", path("a.exr"), path("b.exr"), "--signed-diff", path("f.png")});
              }),
              "--signed-diff " + path("f.png") + ": signed differences are written as .exr");
    EXPECT_FALSE(std::filesystem::exists(path("f.png")));
}

TEST_F(CompareCommandTest, BadInput) {
    const auto errorOf = [&](std::vector<std::string> arguments) -> std::string {
        try {
            run(std::move(arguments));
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_THAT(errorOf({"compare", path("a.exr"), path("small.exr")}), AllOf(HasSubstr("16x12"), HasSubstr("8x8")));
    EXPECT_THAT(errorOf({"compare", path("a.exr"), path("none.exr")}), HasSubstr("none.exr: No such file"));
    EXPECT_THAT(errorOf({"compare", path("a.exr"), path("b.exr"), "--diff", path("no/d.png")}), HasSubstr("no/d.png"));
    EXPECT_THAT(errorOf({"compare", path("a.exr"), path("b.exr"), "--diff", path("d.exr")}),
                AllOf(HasSubstr("d.exr"), HasSubstr(".png")));
    EXPECT_FALSE(std::filesystem::exists(path("d.exr")));
    EXPECT_THROW(run({"compare", path("a.exr")}), CLI::ParseError);
    EXPECT_THROW(run({"compare", path("a.exr"), path("a.exr"), path("a.exr"), path("a.exr")}), CLI::ParseError);
}

TEST_F(CompareCommandTest, WarnsOfNan) {
    testing::internal::CaptureStderr();
    const std::string text = run({"compare", path("a.exr"), path("nan.exr"), "--json"});
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("1 pixel(s) are NaN or infinite"));
    EXPECT_NEAR(nlohmann::json::parse(text)["l1"].get<double>(), 0.25, 1e-9);
}

// Checkers about 0.5 that do not agree: noise of variance 0.0025 whose mean product is nothing.
TEST_F(CompareCommandTest, WithTwoReferencesTheirNoiseIsGone) {
    const auto json =
        nlohmann::ordered_json::parse(run({"compare", path("seed1.exr"), path("seed2.exr"), path("b.exr"), "--json"}));
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    EXPECT_THAT(keys, testing::ElementsAre("error", "error_se", "trimmed_error", "trimmed_error_se", "block_error",
                                           "block_error_se", "reference_noise", "block_reference_noise", "ssim",
                                           "ssim_noise", "ssim_is_noisy", "flip", "flip_noise", "flip_is_noisy",
                                           "mean_ratio", "png_kb", "entropy"));
    EXPECT_NEAR(json["error"].get<double>(), 0, 2e-4);
    EXPECT_NEAR(json["reference_noise"].get<double>(), 0.0025 / 0.26, 1e-4);
    EXPECT_NEAR(json["mean_ratio"][1].get<double>(), 1, 1e-6);
    EXPECT_TRUE(json["ssim_is_noisy"].get<bool>());
    const auto dark =
        nlohmann::json::parse(run({"compare", path("seed1.exr"), path("seed2.exr"), path("a.exr"), "--json"}));
    EXPECT_NEAR(dark["error"].get<double>(), 0.0625 / 0.26, 2e-3);
    EXPECT_FALSE(dark["flip_is_noisy"].get<bool>());
}

TEST_F(CompareCommandTest, TableOfTwoReferences) {
    const std::string text =
        run({"compare", path("seed1.exr"), path("seed2.exr"), path("b.exr"), "--diff", path("d.png")});
    EXPECT_THAT(text, AllOf(HasSubstr("error"), HasSubstr(" +- "), HasSubstr("ref. noise"),
                            HasSubstr("mean ratio  1.0000"), HasSubstr("too much to tell")));
    EXPECT_EQ(readImage(path("d.png")).width(), 64);
}

TEST_F(CompareCommandTest, BadPairsOfReferences) {
    const auto error = [&](const char* first, const char* second, const char* test) {
        return errorOf([&] { run({"compare", path(first), path(second), path(test)}); });
    };
    EXPECT_THAT(error("seed1.exr", "seed1.exr", "b.exr"),
                AllOf(HasSubstr("seed1.exr and"), HasSubstr("are the same picture"), testing::Not(HasSubstr("\n"))));
    EXPECT_THAT(error("seed1.exr", "seed2.exr", "seed2.exr"), HasSubstr("cannot be measured by itself"));
    EXPECT_THAT(error("seed1.exr", "small.exr", "b.exr"), AllOf(HasSubstr("16x12"), HasSubstr("small.exr is 8x8")));
    EXPECT_THAT(error("seed1.exr", "seed2.exr", "small.exr"), AllOf(HasSubstr("16x12"), HasSubstr("small.exr is 8x8")));
    testing::internal::CaptureStderr();
    run({"compare", path("seed1.exr"), path("seed2.exr"), path("nan.exr")});
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("nan.exr: 1 pixel(s) are NaN or infinite"));
}

}  // namespace
}  // namespace drc
