#include "bench/bench_method.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "integrators/integrator.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

std::optional<Adapter> onlyOther(const std::string& name) {
    if (name != "other") return {};
    Adapter adapter;
    adapter.name = "other";
    adapter.denoisers = {"oidn"};
    adapter.commands[BudgetUnit::Spp] = {"run", "{spp}", "{denoiser}"};
    return adapter;
}

std::string line(const std::string& method, const Budget& budget, const OwnProgram& own = {"drc", 16, ""}) {
    BenchJob job;
    job.scene = "s.pbrt", job.output = "o.exr", job.timing = "t.json";
    job.width = 32, job.height = 16, job.threads = 2, job.seed = 5;
    job.budget = budget;
    std::string joined;
    for (const std::string& word : BenchMethod(method, onlyOther).command(job, own)) joined += word + " ";
    return joined;
}

TEST(BenchMethod, OurIntegratorsGetTheirBudget) {
    EXPECT_EQ(line("path", {BudgetUnit::Seconds, 2.5}),
              "drc render s.pbrt --integrator path --denoise off --time 2.5 --resolution 32x16 --nthreads 2 --seed 5 "
              "--timing t.json --quiet -o o.exr ");
    EXPECT_THAT(line("bdpt", {BudgetUnit::Spp, 64}), HasSubstr("--integrator bdpt --denoise off --spp 64 "));
    EXPECT_THAT(line("drc", {BudgetUnit::Spp, 64}), HasSubstr("--integrator drc --spp 64 "));
    EXPECT_THAT(line("drc-maps", {BudgetUnit::Tasks, 256}, {"drc", 8, ""}),
                AllOf(HasSubstr("--indirect-tasks 256 --spp 8 "), Not(HasSubstr("--denoise"))));
}

TEST(BenchMethod, MapDenoisersNetworksAndDenoisers) {
    const Budget budget{BudgetUnit::Seconds, 1};
    EXPECT_THAT(line("drc-maps:gaussian", budget), HasSubstr("--integrator drc-maps --map-denoiser gaussian "));
    EXPECT_THAT(line("drc-maps:paper-k64+off", budget),
                AllOf(HasSubstr("--weights paper-k64 "), HasSubstr("--denoise off ")));
    EXPECT_THAT(line("path+oidn", budget, {"drc", 16, "lib.so"}),
                AllOf(HasSubstr("--denoise oidn "), HasSubstr("--oidn-library lib.so ")));
    EXPECT_THAT(line("path", budget, {"drc", 16, "lib.so"}), Not(HasSubstr("lib.so")));
}

// 32x16 pixels are denoised in no time; of a budget in samples denoising takes nothing.
TEST(BenchMethod, OpenImageDenoiseIsAskedForAMode) {
    const Budget second{BudgetUnit::Seconds, 1}, little{BudgetUnit::Seconds, 1e-4}, samples{BudgetUnit::Spp, 1};
    const char *best = "--denoise oidn --oidn-quality high --oidn-prefilter on ",
               *quick = "--denoise oidn --oidn-quality balanced --oidn-prefilter off ";
    EXPECT_THAT(line("path+oidn", second), HasSubstr(best));
    EXPECT_THAT(line("path+oidn", samples), HasSubstr(best));
    EXPECT_THAT(line("drc+oidn", second), HasSubstr(best));
    EXPECT_THAT(line("path+oidn", little), HasSubstr("--denoise oidn --oidn-quality fast --oidn-prefilter off "));
    EXPECT_THAT(line("path+oidn:balanced-raw", second), HasSubstr(quick));
    EXPECT_THAT(line("path+oidn:high", little), HasSubstr(best));
    EXPECT_THAT(line("path+oidn:high-raw", second), HasSubstr("--oidn-quality high --oidn-prefilter off "));
    EXPECT_THAT(line("path+oidn:balanced", second), HasSubstr("--oidn-quality balanced --oidn-prefilter on "));
    EXPECT_THAT(line("drc-maps+oidn-direct:fast-raw", second),
                HasSubstr("--denoise oidn-direct --oidn-quality fast --oidn-prefilter off "));
    EXPECT_THAT(line("drc+off", second), Not(HasSubstr("--oidn")));
    BenchJob job;
    job.budget = second;
    EXPECT_EQ(BenchMethod("path+oidn:fast-raw", onlyOther).oidnMode(job)->name, std::string("fast-raw"));
    EXPECT_EQ(BenchMethod("path", onlyOther).oidnMode(job), nullptr);
    EXPECT_EQ(BenchMethod("other+oidn", onlyOther).oidnMode(job), nullptr);
}

TEST(BenchMethod, OptionsOfOnesOwn) {
    const std::string many = "many maps=--integrator drc-maps --spacing 2";
    EXPECT_EQ(BenchMethod(many, onlyOther).name(), "many maps");
    EXPECT_THAT(line(many, {BudgetUnit::Tasks, 4}), HasSubstr("render s.pbrt --integrator drc-maps --spacing 2 "));
    EXPECT_TRUE(BenchMethod(many, onlyOther).keeps(BudgetUnit::Tasks));
    for (const char* samples : {"a=--integrator path", "a=--integrator=bdpt", "a=--integrator scene", "a=--clamp 2"}) {
        EXPECT_FALSE(BenchMethod(samples, onlyOther).keeps(BudgetUnit::Tasks)) << samples;
        EXPECT_TRUE(BenchMethod(samples, onlyOther).keeps(BudgetUnit::Spp)) << samples;
    }
}

TEST(BenchMethod, OtherProgramsByTheirAdapter) {
    EXPECT_EQ(line("other", {BudgetUnit::Spp, 8}), "run 8 off ");
    EXPECT_EQ(line("other+oidn", {BudgetUnit::Spp, 8}), "run 8 oidn ");
    EXPECT_FALSE(BenchMethod("other", onlyOther).keeps(BudgetUnit::Seconds));
    EXPECT_TRUE(BenchMethod("other", onlyOther).keeps(BudgetUnit::Spp));
}

TEST(BenchMethod, UnitsThatOursKeep) {
    for (const std::string& name : integratorNames()) {
        const BenchMethod method(name, onlyOther);
        EXPECT_TRUE(method.keeps(BudgetUnit::Seconds)) << name;
        EXPECT_EQ(method.keeps(BudgetUnit::Spp), name != "drc-maps") << name;
        EXPECT_EQ(method.keeps(BudgetUnit::Tasks), name == "drc-maps") << name;
    }
}

TEST(BenchMethod, ErrorsSayWhatWouldBeRight) {
    const auto error = [](const std::string& text) { return errorOf([&] { BenchMethod(text, onlyOther); }); };
    EXPECT_THAT(error("pathh"), AllOf(HasSubstr("'pathh'"), HasSubstr("bdpt")));
    for (const char* method : {"path:gaussian", "drc:gaussian", "drc:paper-k64", "drc-maps:"})
        EXPECT_THAT(error(method), HasSubstr("only drc-maps takes a map denoiser or a network, as drc-maps:gaussian"));
    EXPECT_THAT(error("drc+nlm"), HasSubstr("oidn-direct"));
    for (const char* method : {"path+surface", "drc+surface", "drc+oidn-direct"})
        EXPECT_THAT(error(method), HasSubstr("only drc-maps has"));
    EXPECT_THAT(error("a=--integrator photon"), HasSubstr("no integrator 'photon'"));
    EXPECT_THAT(error("other+optix"), HasSubstr("'optix'"));
    EXPECT_THAT(error("path+oidn:best"), AllOf(HasSubstr("'path+oidn:best'"), HasSubstr("balanced-raw, fast-raw")));
    EXPECT_THAT(error("drc-maps+surface:high"), HasSubstr("oidn and oidn-direct have the modes"));
    EXPECT_THAT(error("=--spacing 2"), HasSubstr("no name"));
}

}  // namespace
}  // namespace drc
