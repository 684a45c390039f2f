#include "app/display_options.h"

#include <fmt/ranges.h>

#include "app/option_checks.h"
#include "app/usage_error.h"
#include "render/picture_writer.h"

namespace drc {
namespace {

constexpr const char* kOptions[] = {"--exposure", "--auto-exposure", "--view"};

}  // namespace

void addDisplayOptions(CLI::App& command, DisplaySettings& display, const std::string& group) {
    const std::string before = command.option_defaults()->get_group();
    if (!group.empty()) command.option_defaults()->group(group);
    command
        .add_option("--exposure", display.exposure,
                    "Stops by which PNG files are brightened: 1 doubles the light; EXR files stay linear and unexposed")
        ->capture_default_str()
        ->check(numberIn(-100, 100));
    command.add_flag("--auto-exposure", display.autoExposure,
                     "Find the exposure of PNG files from the picture; --exposure is added to it");
    std::vector<std::string> names;
    for (const View view : allViews()) names.push_back(viewName(view));
    command
        .add_option_function<std::string>(
            "--view",
            [&display](const std::string& name) {
                for (const View view : allViews())
                    if (viewName(view) == name) display.view = view;
            },
            "How PNG files show what is brighter than a display: srgb clips it; filmic and agx compress it, filmic "
            "channel by channel, agx with less change of hue. Default: srgb")
        ->check(CLI::IsMember(names));
    command.option_defaults()->group(before);
}

std::string givenDisplayOptions(const CLI::App& command) {
    std::vector<std::string> given;
    for (const char* name : kOptions)
        if (command.count(name) > 0) given.push_back(name);
    return fmt::format("{}", fmt::join(given, ", "));
}

void refuseDisplayOptionsWithoutPng(const CLI::App& command, const std::vector<std::string>& outputs) {
    for (const std::string& path : outputs)
        if (outputKind(path) == OutputKind::Png) return;
    if (const std::string given = givenDisplayOptions(command); !given.empty())
        throw UsageError(given + ": EXR files stay linear and unexposed; give a .png as output");
}

}  // namespace drc
