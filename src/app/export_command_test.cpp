#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/command_testing.h"
#include "app/usage_error.h"
#include "base/atomic_file.h"
#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ExportCommand : public FolderTest {
  protected:
    static std::string run(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "export");
        return test::outputOf(addExportCommand, std::move(arguments));
    }
    static std::string fault(const std::vector<std::string>& arguments) {
        try {
            run(arguments);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    }
    std::string scene() const {
        folder_.write("inner.pbrt",
                      "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0]\n");
        return folder_.write("scene.pbrt",
                             "Film \"image\"\nWorldBegin\nTranslate 1 2 3\nInclude \"inner.pbrt\"\nWorldEnd\n");
    }
    std::string writtenMesh() const {
        run({"--json", scene(), "--meshes", path("m1")});
        return path("m1/0.ply");
    }
};

TEST_F(ExportCommand, WritesJsonToStandardOutputAndToFiles) {
    const std::string text = run({"--json", scene()});
    const auto json = nlohmann::json::parse(text);
    EXPECT_EQ(json["shapes"].size(), 1u);
    EXPECT_EQ(json["files"][json["shapes"][0]["at"][0].get<size_t>()], path("inner.pbrt"));
    EXPECT_EQ(run({scene(), "--json", "-o", path("s.json")}), "");
    EXPECT_EQ(readFile(path("s.json")), text);
}

TEST_F(ExportCommand, WritesMeshes) {
    const auto json = nlohmann::json::parse(run({"--json", scene(), "--meshes", path("m")}));
    EXPECT_EQ(json["shapes"][0]["mesh"]["file"], path("m/0.ply"));
    EXPECT_EQ(json["shapes"][0]["mesh"]["bounds"], nlohmann::json::parse("[[1, 2, 3], [2, 3, 3]]"));
    EXPECT_TRUE(std::filesystem::exists(path("m/0.ply")));
}

TEST_F(ExportCommand, WritesPbrt) {
    const std::string copy =
        run({"--pbrt", scene(), "--resolution", "64x48", "--spp", "20", "--integrator", "path", "--max-depth", "100"});
    EXPECT_THAT(copy, StartsWith("# pbrt-v3\nFilm \"image\" \"integer xresolution\" [ 64 ]"));
    EXPECT_THAT(copy, HasSubstr("\"integer pixelsamples\" [ 20 ]"));
    EXPECT_THAT(copy, HasSubstr("Integrator \"path\" \"integer maxdepth\" [ 100 ]"));
    EXPECT_THAT(copy, HasSubstr("Translate 1 2 3\nShape \"trianglemesh\""));
}

TEST_F(ExportCommand, RefusesWhatCannotBeMeant) {
    const std::string file = scene();
    EXPECT_THAT(fault({file}), HasSubstr("one of --json and --pbrt"));
    EXPECT_THAT(fault({file, "--json", "--pbrt"}), HasSubstr("one of --json and --pbrt"));
    EXPECT_THAT(fault({file, "--json", "--spp", "4"}), StartsWith("--spp: "));
    EXPECT_THAT(fault({file, "--pbrt", "--meshes", path("m")}), StartsWith("--meshes: "));
    EXPECT_THAT(fault({file, "--pbrt", "--max-depth", "4"}), StartsWith("--max-depth: "));
    EXPECT_THAT(fault({file, "--pbrt", "--resolution", "64"}), StartsWith("--resolution 64: "));
}

TEST_F(ExportCommand, LeavesNothingHalfWritten) {
    const std::string broken = folder_.write("broken.pbrt", "WorldBegin\nShape \"sphere\" \"float radius\" [x]\n");
    for (const char* form : {"--json", "--pbrt"}) {
        const std::string out = path("out");
        const std::string wrong = folder_.write("none.pbrt", "WorldBegin\nInclude \"nothing.pbrt\"\n");
        EXPECT_THAT(errorOf([&] { run({form, wrong, "-o", out}); }), StartsWith(wrong + ":2:9: "));
        EXPECT_FALSE(std::filesystem::exists(out));
        EXPECT_THAT(errorOf([&] { run({form, broken, "-o", broken}); }), HasSubstr("--output"));
    }
    for (const char* form : {"--json", "--pbrt"}) {
        EXPECT_THAT(errorOf([&] { run({form, scene(), "-o", path("inner.pbrt")}); }), StartsWith("--output"));
        EXPECT_THAT(readFile(path("inner.pbrt")), StartsWith("Shape"));
    }
    const std::string with =
        folder_.write("with.pbrt", "WorldBegin Shape \"plymesh\" \"string filename\" \"m2/0.ply\" WorldEnd");
    folder_.write("m2/0.ply", readFile(writtenMesh()));
    EXPECT_THAT(errorOf([&] { run({"--json", with, "--meshes", path("m2")}); }), StartsWith("--meshes"));
    EXPECT_THAT(errorOf([&] { run({"--json", broken, "--meshes", path("m")}); }), StartsWith(broken + ":2:32: "));
    EXPECT_FALSE(std::filesystem::exists(path("m")));
    EXPECT_THAT(errorOf([&] { run({"--json", scene(), "-o", path("no/out.json")}); }), HasSubstr("no/out.json"));
}

}  // namespace
}  // namespace drc
