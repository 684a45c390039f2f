// Runs `drc bench` as a user would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "bench/measured_process.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kScene = R"(
Film "image" "integer xresolution" 24 "integer yresolution" 16
LookAt 0 0 -3  0 0 0  0 1 0
Camera "perspective" "float fov" 60
WorldBegin
AttributeBegin
AreaLightSource "diffuse" "rgb L" [8 8 8]
Translate 0 1.6 0 Shape "sphere" "float radius" .4
AttributeEnd
Shape "sphere" "float radius" 1
ReverseOrientation
Shape "sphere" "float radius" 4
WorldEnd
)";

class BenchCommand : public FolderTest {
  protected:
    BenchCommand() { folder_.write("room/scene.pbrt", kScene); }

    ProcessUse bench(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {DRC_PROGRAM, "bench", path("room/scene.pbrt"), "-o", path("out")});
        return runMeasured(arguments);
    }
    nlohmann::json json() const { return nlohmann::json::parse(readFile(path("out/bench.json"))); }
};

TEST_F(BenchCommand, ComparesWithAReferenceOfItsOwn) {
    const std::vector<std::string> arguments{"--methods",
                                             "path,bdpt,drc+off,drc-maps:gaussian,drc-maps",
                                             "--spp",
                                             "2..4",
                                             "--tasks",
                                             "1",
                                             "--direct-spp",
                                             "2",
                                             "--method",
                                             "fine=--integrator drc-maps --spacing 4",
                                             "--reference-error",
                                             "0.01",
                                             "--resolution",
                                             "24x16",
                                             "--repeats",
                                             "2"};
    const ProcessUse use = bench(arguments);
    ASSERT_EQ(use.exitCode, 0) << use.output;
    EXPECT_THAT(use.output, AllOf(HasSubstr("| room  | path"), HasSubstr("## 1 task\n"), HasSubstr("0 failed")));
    const auto report = json();
    EXPECT_EQ(report["scenes"][0]["width"], 24);
    EXPECT_THAT(report["scenes"][0]["reference_origin"].get<std::string>(), HasSubstr("path, 2 x "));
    ASSERT_EQ(report["scenes"][0]["reference_pair"].size(), 2u);
    EXPECT_EQ(report["runs"].size(), 2u * (3 * 2 + 3));
    for (const auto& run : report["runs"]) {
        EXPECT_FALSE(run.contains("failure")) << run;
        EXPECT_LT(run["error"], 1);
        EXPECT_GT(run["error_se"], 0);
        EXPECT_LT(run["block_error"], run["error"]);
        EXPECT_GT(run["spp"], 0);
        // Of the layers of radiance maps; the others have no denoiser here.
        const bool maps = run["budget"]["unit"] == "tasks";
        EXPECT_EQ(run["denoise_seconds"].get<double>() > 0.0005, maps) << run;
        for (const double ratio : run["mean_ratio"]) EXPECT_NEAR(ratio, 1, 0.2) << run;
        EXPECT_GT(run["seconds"], run["render_seconds"]);
        EXPECT_GT(run["peak_mb"], 1);
    }
    const std::string page = readFile(path("out/index.html"));
    EXPECT_THAT(page, AllOf(HasSubstr("fine"), HasSubstr("data:image/png;base64,")));

    // drc compare finds the same error.
    const std::string first = report["scenes"][0]["reference_pair"][0],
                      second = report["scenes"][0]["reference_pair"][1];
    const std::string picture = report["runs"][0]["picture"];
    const ProcessUse compared = runMeasured(
        {DRC_PROGRAM, "compare", path("out/" + first), path("out/" + second), path("out/" + picture), "--json"});
    EXPECT_EQ(nlohmann::json::parse(compared.output)["error"], report["runs"][0]["error"]);

    // A second run must not measure anything again.
    EXPECT_EQ(bench(arguments).exitCode, 0);
    EXPECT_EQ(json(), report);
}

TEST_F(BenchCommand, BadRequestsGetOneLine) {
    const auto error = [&](const std::vector<std::string>& arguments) {
        const ProcessUse use = bench(arguments);
        EXPECT_NE(use.exitCode, 0);
        EXPECT_FALSE(std::filesystem::exists(path("out/index.html")));
        return use.output;
    };
    EXPECT_THAT(error({"--seconds", "ten"}), HasSubstr("--seconds ten"));
    EXPECT_THAT(error({"--seconds", "-1"}), HasSubstr("positive"));
    EXPECT_THAT(error({"--methods", "path", "--spp", "1.5"}), HasSubstr("whole"));
    EXPECT_THAT(error({"--methods", "pathe"}), HasSubstr("'pathe'"));
    EXPECT_THAT(error({"--methods", "path,path"}), HasSubstr("two methods"));
    EXPECT_THAT(error({"--methods", "drc-maps", "--spp", "4"}), HasSubstr("drc-maps keeps none"));
    EXPECT_THAT(error({"--methods", "drc", "--tasks", "4"}), HasSubstr("drc keeps none"));
    EXPECT_THAT(error({"--method", "--spacing 4"}), HasSubstr("NAME=OPTIONS"));
    EXPECT_THAT(error({"--adapter", path("none")}), HasSubstr("none"));
    EXPECT_THAT(error({"--resolution", "64"}), HasSubstr("1280x720"));
    EXPECT_THAT(error({"--resolution", "64x10"}), HasSubstr("from 11 pixels"));
    EXPECT_THAT(error({"--references", path("nowhere")}), HasSubstr("room-1.exr"));
    EXPECT_THAT(error({"--methods", "path+oidn:best"}), HasSubstr("fast-raw"));
    folder_.write("room/scene.pbrt", "Shape \"sphere\"\n");
    EXPECT_THAT(error({}), HasSubstr("scene.pbrt:1:"));
}

}  // namespace
}  // namespace drc
