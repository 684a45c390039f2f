#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/evaluation_testing.h"
#include "app/laboratory.h"
#include "base/atomic_file.h"

namespace drc {
namespace {

class EvaluateCommandTest : public EvaluationTest {
  protected:
    // What the command prints. Throws what it throws.
    static std::string evaluateWith(std::vector<std::string> arguments) {
        CLI::App app;
        addEvaluateCommand(app);
        arguments.insert(arguments.begin(), "evaluate");
        std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
        testing::internal::CaptureStdout();
        try {
            app.parse(arguments);
        } catch (...) {
            testing::internal::GetCapturedStdout();
            throw;
        }
        return testing::internal::GetCapturedStdout();
    }

    const std::string a = network("a.safetensors", "equal-area", 1), b = network("b.safetensors", "latlong", 2);
};

TEST_F(EvaluateCommandTest, WeightsMayStandAnywhereAndBeRepeated) {
    const std::string first = evaluateWith({"--weights", a, path("ea"), "--weights", b, path("ll"), "--json"});
    EXPECT_EQ(evaluateWith({path("ea"), path("ll"), "--json", "--weights", a, "--weights", b}), first);
    EXPECT_EQ(nlohmann::json::parse(first)["networks"].size(), 2u);
    EXPECT_EQ(nlohmann::json::parse(first)["examples"], 10);
}

TEST_F(EvaluateCommandTest, NamesPicturesInTheJson) {
    const auto run = [&](const std::string& folder, const std::string& seed) {
        return nlohmann::json::parse(evaluateWith(
            {path("ea"), "--weights", a, "--json", "--pictures", path(folder), "--samples", "3", "--seed", seed}));
    };
    const auto json = run("new/folder", "0");
    EXPECT_EQ(json["samples"]["seed"], 0);
    EXPECT_EQ(json["projections"][0]["samples"].size(), 3u);
    for (const auto& sample : json["projections"][0]["samples"])
        EXPECT_TRUE(std::filesystem::exists(path("new/folder/" + sample["reference"].get<std::string>())));
    EXPECT_EQ(run("again", "0"), json);
    EXPECT_NE(run("other", "7")["projections"], json["projections"]);
    EXPECT_FALSE(nlohmann::json::parse(evaluateWith({path("ea"), "--weights", a, "--json"})).contains("samples"));
}

TEST_F(EvaluateCommandTest, WritesAPageBesideTheTable) {
    if (runLaboratory("check") != 0) GTEST_SKIP() << "Python lacks a module of the laboratory";
    const std::string table = evaluateWith({path("ea"), "--weights", a, "--html", path("page.html"), "--samples", "3"});
    EXPECT_NE(table.find("a against gaussian"), std::string::npos);
    const std::string page = readFile(path("page.html")), example = "class=\"example\"";
    size_t count = 0;
    for (size_t at = page.find(example); at != std::string::npos; at = page.find(example, at + 1)) ++count;
    EXPECT_EQ(count, 3u);
}

TEST_F(EvaluateCommandTest, APageThatCannotBeWrittenIsAnErrorAndLeavesNothing) {
    EXPECT_NE(errorOf([&] { evaluateWith({path("ea"), "--weights", a, "--html", path("no/page.html")}); }), "");
    EXPECT_NE(errorOf([&] { evaluateWith({path("missing"), "--html", path("page.html")}); }), "");
    EXPECT_FALSE(std::filesystem::exists(path("page.html")));
}

}  // namespace
}  // namespace drc
