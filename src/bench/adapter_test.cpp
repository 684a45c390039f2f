#include "bench/adapter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kWhole = R"({"name": "other", "about": "another renderer", "install": "buy it",
    "check": ["{folder}/check", "--version"], "denoisers": ["oidn"],
    "command": {"seconds": ["run", "--time={seconds}", "{scene}", "{output}"],
                "spp": ["run", "{spp}", "{width}x{height}", "{seed}", "{threads}", "{denoiser}", "{timing}", "{{x}}"]}})";

class AdapterFile : public FolderTest {
  protected:
    Adapter read(const std::string& json) { return readAdapter(folder_.write("adapter.json", json)); }
    std::string errorOf(const std::string& json) {
        return drc::errorOf([&] { read(json); });
    }
};

TEST_F(AdapterFile, SaysHowToRunAProgram) {
    const Adapter adapter = read(kWhole);
    EXPECT_EQ(adapter.name, "other");
    EXPECT_EQ(adapter.folder, folder_.path());
    EXPECT_THAT(adapter.check, ElementsAre(adapter.folder + "/check", "--version"));
    EXPECT_TRUE(adapter.denoises("oidn"));
    EXPECT_FALSE(adapter.denoises("surface"));
    AdapterValues values;
    values.scene = "a {b}.pbrt", values.output = "o.exr", values.timing = "t.json", values.denoiser = "oidn";
    values.width = 64, values.height = 48, values.threads = 2, values.seed = 3, values.amount = 2.5;
    EXPECT_THAT(adapter.command(BudgetUnit::Seconds, values).value(),
                ElementsAre("run", "--time=2.5", "a {b}.pbrt", "o.exr"));
    values.amount = 16;
    EXPECT_THAT(adapter.command(BudgetUnit::Spp, values).value(),
                ElementsAre("run", "16", "64x48", "3", "2", "oidn", "t.json", "{x}"));
    EXPECT_FALSE(adapter.command(BudgetUnit::Tasks, values));
}

TEST_F(AdapterFile, NoDenoiserIsOff) { EXPECT_EQ(read(kWhole).command(BudgetUnit::Spp, {}).value()[5], "off"); }

TEST_F(AdapterFile, MayBeNamedByItsFolder) {
    read(kWhole);
    EXPECT_EQ(readAdapter(folder_.path()).name, "other");
}

TEST_F(AdapterFile, ErrorsNameTheFileAndTheKey) {
    const auto with = [](const std::string& before, const std::string& after) {
        std::string json = kWhole;
        return json.replace(json.find(before), before.size(), after);
    };
    EXPECT_THAT(errorOf("{"), testing::AllOf(HasSubstr(path("adapter.json")), HasSubstr("not JSON")));
    EXPECT_THAT(errorOf("[]"), HasSubstr("object"));
    EXPECT_THAT(errorOf(with("\"name\"", "\"nome\"")), HasSubstr("\"nome\""));
    EXPECT_THAT(errorOf(with("\"name\": \"other\", ", "")), HasSubstr("\"name\" is missing"));
    EXPECT_THAT(errorOf(with("\"other\"", "\"a+b\"")), HasSubstr("a+b"));
    EXPECT_THAT(errorOf(with("\"other\"", "7")), HasSubstr("\"name\""));
    EXPECT_THAT(errorOf(with("[\"oidn\"]", "\"oidn\"")), HasSubstr("\"denoisers\""));
    EXPECT_THAT(errorOf(with("{scene}", "{scone}")), testing::AllOf(HasSubstr("{scone}"), HasSubstr("threads")));
    EXPECT_THAT(errorOf(with("{seconds}", "{spp}")), HasSubstr("{spp}"));
    EXPECT_THAT(errorOf(with("{scene}", "{scene")), HasSubstr("not closed"));
    EXPECT_THAT(errorOf(with("{scene}", "scene}")), HasSubstr("not opened"));
    EXPECT_THAT(errorOf(with("\"spp\":", "\"tasks\":")), HasSubstr("\"tasks\""));
    EXPECT_THAT(errorOf(with("{folder}", "{scene}")), HasSubstr("\"check\""));
    EXPECT_THROW(readAdapter(path("none.json")), Error);
}

}  // namespace
}  // namespace drc
