#include "app/command_line.h"

#include <gmock/gmock.h>

#include "app/usage_error.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// Of subcommands of the given path, all that is done is to read their options.
CLI::App& onlyRead(CLI::App& app, const std::vector<std::string>& path) {
    CLI::App* command = &app;
    for (const std::string& name : path) command = command->get_subcommand(name);
    command->callback([] {});
    return *command;
}

void parse(CLI::App& app, std::vector<std::string> arguments) {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
    app.parse(std::move(arguments));
}

// What is said of the command line; empty if it is fine or asks for help.
std::string fault(const std::vector<std::string>& arguments) {
    const auto app = makeCommandLine();
    for (const char* name : {"render", "view", "info", "bench", "compare"}) onlyRead(*app, {name});
    onlyRead(*app, {"image", "convert"});
    try {
        parse(*app, arguments);
        return "";
    } catch (const CLI::ParseError& error) {
        const std::string text = usageFault(*app, error);
        EXPECT_THAT(text, Not(HasSubstr("\n")));
        return text;
    }
}

TEST(CommandLine, UnknownCommandsNameTheNearest) {
    EXPECT_EQ(fault({"rendr", "scene.pbrt"}), "drc has no command 'rendr'; did you mean 'render'?");
    EXPECT_EQ(fault({"image", "convrt", "a.exr"}), "drc image has no command 'convrt'; did you mean 'convert'?");
    EXPECT_THAT(fault({"xyzzy"}), AllOf(StartsWith("drc has no command 'xyzzy'"), HasSubstr("render, view")));
    // Not the help of another command.
    EXPECT_THAT(fault({"rendr", "--help"}), HasSubstr("'render'"));
    EXPECT_EQ(fault({"scene.pbrt"}), "a command comes before the scene: drc render scene.pbrt");
    EXPECT_THAT(fault({}), HasSubstr("drc needs a command: render, view"));
    EXPECT_THAT(fault({"image"}), HasSubstr("drc image needs a command: convert"));
}

TEST(CommandLine, UnknownOptionsNameTheNearest) {
    EXPECT_EQ(fault({"render", "scene.pbrt", "--sppp", "16"}),
              "drc render has no option '--sppp'; did you mean '--spp'?");
    EXPECT_EQ(fault({"render", "--sppp=16", "scene.pbrt"}), "drc render has no option '--sppp'; did you mean '--spp'?");
    EXPECT_EQ(fault({"render", "--sppp", "16", "scene.pbrt"}),
              "drc render has no option '--sppp'; did you mean '--spp'?");
    EXPECT_EQ(fault({"render", "scene.pbrt", "-spp", "16"}), "drc render has no option '-spp'; did you mean '--spp'?");
    EXPECT_EQ(fault({"image", "convert", "a.exr", "-o", "b.png", "--exposre", "1"}),
              "drc image convert has no option '--exposre'; did you mean '--exposure'?");
    EXPECT_EQ(fault({"render", "scene.pbrt", "--xyzzy"}),
              "drc render has no option '--xyzzy'; drc render --help lists them");
    EXPECT_THAT(fault({"render", "scene.pbrt", "--samples", "16"}), EndsWith("did you mean '--spp'?"));
    EXPECT_EQ(fault({"--spp", "16", "render", "scene.pbrt"}),
              "drc has no option '--spp'; it belongs after the command: drc render ... --spp");
    EXPECT_THAT(fault({"render", "a.pbrt", "b.pbrt"}), HasSubstr("'b.pbrt' is one file too many for drc render"));
}

TEST(CommandLine, WhatIsMissingIsNamed) {
    EXPECT_THAT(fault({"render"}), AllOf(HasSubstr("drc render: SCENE is required"), HasSubstr("drc render --help")));
    EXPECT_EQ(fault({"render", "a.pbrt", "--spp"}), "drc render: --spp needs a value: INT in [1, 16777216]");
    EXPECT_EQ(fault({"render", "a.pbrt", "--crop", "0", "1"}), "drc render: --crop needs 4 values: X0 X1 Y0 Y1");
    EXPECT_THAT(fault({"image", "convert", "a.exr", "-o", "b.exr", "--crop", "0", "1"}), HasSubstr("--crop needs 4"));
    for (const char* option : {"--resolution", "--checkpoint", "--resume", "--timing", "-o", "--seed"})
        EXPECT_THAT(fault({"render", "a.pbrt", option, ""}), EndsWith("the value is empty")) << option;
    EXPECT_THAT(fault({"compare", "a.exr"}), HasSubstr("PICTURE: At least 2 required"));
    EXPECT_THAT(fault({"compare", "a.exr", "b.exr", "c.exr", "d.exr"}), Not(testing::IsEmpty()));
    EXPECT_EQ(fault({"render", "a.pbrt", "--checkpoint", "--resume", "state"}),
              "drc render: --checkpoint: a value is missing before --resume");
    EXPECT_THAT(fault({"render", "a.pbrt", "--lookat", "0", "0", "1", "0", "--spp", "4"}), HasSubstr("--lookat"));
}

TEST(CommandLine, HelpIsNoFault) {
    for (const char* command : {"render", "view", "bench"}) EXPECT_EQ(fault({command, "--help"}), "");
    EXPECT_EQ(fault({"--help"}), "");
    EXPECT_EQ(fault({"--version"}), "");
    EXPECT_EQ(fault({"image", "convert", "--help"}), "");
}

TEST(CommandLine, HelpsNameTheirOwnCommand) {
    const auto app = makeCommandLine(), all = makeCommandLine();
    const auto help = [&](const std::vector<std::string>& path) {
        try {
            std::vector<std::string> arguments = path;
            arguments.emplace_back("--help");
            parse(*app, arguments);
        } catch (const CLI::ParseError&) {
        }
        return app->help();
    };
    EXPECT_THAT(help({"render"}), AllOf(HasSubstr("Usage: drc render "), HasSubstr("drc render scene.pbrt")));
    for (const CLI::App* command : all->get_subcommands({}))
        EXPECT_THAT(help({command->get_name()}), HasSubstr("Usage: drc " + command->get_name() + " "));
    for (const CLI::App* command : all->get_subcommand("image")->get_subcommands({}))
        EXPECT_THAT(help({"image", command->get_name()}),
                    AllOf(HasSubstr("Usage: drc image " + command->get_name() + " "),
                          HasSubstr("drc image " + command->get_name())));
    EXPECT_THAT(help({"image", "diff"}), Not(HasSubstr("drc compare")));
}

TEST(CommandLine, ARepeatedOptionOverrides) {
    const auto app = makeCommandLine();
    const CLI::App& render = onlyRead(*app, {"render"});
    parse(*app, {"render",       "a.pbrt",
                 "--spp",        "4",
                 "--integrator", "path",
                 "--spp",        "8",
                 "--integrator", "bdpt",
                 "--view",       "agx",
                 "--view",       "srgb",
                 "--crop",       "0",
                 ".5",           "0",
                 ".5",           "--crop",
                 ".5",           "1",
                 ".25",          "1",
                 "--time",       "3",
                 "--time",       "4",
                 "-o",           "a.exr",
                 "-o",           "a.png",
                 "-D",           "film.xresolution=3",
                 "-D",           "film.yresolution=4"});
    const auto last = [&](const char* name) { return render.get_option(name)->as<std::string>(); };
    EXPECT_EQ(last("--spp"), "8");
    EXPECT_EQ(last("--integrator"), "bdpt");
    EXPECT_EQ(last("--view"), "srgb");
    EXPECT_EQ(last("--time"), "4");
    EXPECT_EQ(render.get_option("--crop")->as<std::vector<double>>(), (std::vector<double>{.5, 1, .25, 1}));
    EXPECT_EQ(render.get_option("-o")->as<std::vector<std::string>>(), (std::vector<std::string>{"a.exr", "a.png"}));
    EXPECT_EQ(render.get_option("-D")->as<std::vector<std::string>>().size(), 2u);
}

TEST(CommandLine, NumbersThatMeanNothingAreRefusedEverywhere) {
    const std::vector<std::vector<std::string>> wrong{{"render", "a.pbrt", "--seed", "-1"},
                                                      {"render", "a.pbrt", "--seed", "1.5"},
                                                      {"render", "a.pbrt", "--seed", "18446744073709551616"},
                                                      {"render", "a.pbrt", "--nthreads", "100000"},
                                                      {"render", "a.pbrt", "--time", "1e30"},
                                                      {"render", "a.pbrt", "--spp", "2000000000"},
                                                      {"render", "a.pbrt", "--fov", "180"},
                                                      {"render", "a.pbrt", "--fov", "0"},
                                                      {"render", "a.pbrt", "--fov", "nan"},
                                                      {"view", "a.pbrt", "--nthreads", "100000"},
                                                      {"view", "a.pbrt", "--seed", "-1"},
                                                      {"view", "a.pbrt", "--spp", "nan"},
                                                      {"view", "a.pbrt", "--port", "65536"},
                                                      {"compare", "a.exr", "b.exr", "--exposure", "nan"}};
    for (const auto& arguments : wrong)
        EXPECT_THAT(fault(arguments), AllOf(StartsWith("drc " + arguments[0] + ": " + *(arguments.end() - 2)),
                                            HasSubstr(arguments.back())));
    EXPECT_EQ(fault({"render", "a.pbrt", "--seed", "18446744073709551615", "--nthreads", "64", "--fov", "179.5"}), "");
    EXPECT_EQ(fault({"render", "a.pbrt", "--lookat", "-.5", "-1e1", "-3", "0", "0", "-.25", "0", "-1", "-.5"}), "");
}

TEST(UsageError, TakesTheWordsOfOtherErrors) {
    EXPECT_EQ(asUsage([] { return 3; }), 3);
    try {
        asUsage([] { throw Error("so"); });
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "so");
    }
}

}  // namespace
}  // namespace drc
