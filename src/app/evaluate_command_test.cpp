#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/evaluation_testing.h"
#include "base/atomic_file.h"
#include "report/html_testing.h"

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

TEST_F(EvaluateCommandTest, WritesAPageBesideTheTable) {
    const std::string table = evaluateWith({path("ea"), "--weights", a, "--html", path("page.html"), "--samples", "3"});
    EXPECT_NE(table.find("a against gaussian"), std::string::npos);
    const std::string page = readFile(path("page.html"));
    EXPECT_EQ(brokenNesting(page), "");
    EXPECT_EQ(occurrences(page, "class=\"example\""), 3);
    evaluateWith({path("ea"), "--weights", a, "--html", path("again.html"), "--samples", "3"});
    EXPECT_EQ(readFile(path("again.html")), page);
    evaluateWith({path("ea"), "--weights", a, "--html", path("other.html"), "--samples", "3", "--seed", "7"});
    EXPECT_NE(readFile(path("other.html")), page);
}

TEST_F(EvaluateCommandTest, APageThatCannotBeWrittenIsAnErrorAndLeavesNothing) {
    EXPECT_NE(errorOf([&] { evaluateWith({path("ea"), "--weights", a, "--html", path("no/page.html")}); }), "");
    EXPECT_NE(errorOf([&] { evaluateWith({path("missing"), "--html", path("page.html")}); }), "");
    EXPECT_FALSE(std::filesystem::exists(path("page.html")));
}

}  // namespace
}  // namespace drc
