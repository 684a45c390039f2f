#include "app/command_line.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <utility>

#include "app/command.h"
#include "app/compare_command.h"
#include "app/usage_error.h"
#include "base/log.h"
#include "base/suggest.h"

namespace drc {
namespace {

constexpr const char* kIntroduction =
    "DRC renders scenes of pbrt-v3 and pbrt-v4, on a CPU. A scene of your own:\n\n"
    "    drc render scene.pbrt -o picture.png              # a picture\n"
    "    drc render scene.pbrt -o picture.png --time 30    # the best that 30 seconds give\n"
    "    drc view scene.pbrt --open                        # watch it refine in a browser, move the camera\n";

// Options of other renderers, with their names here.
constexpr std::pair<const char*, const char*> kElsewhere[] = {
    {"--samples", "--spp"},       {"--width", "--resolution"},
    {"--height", "--resolution"}, {"--size", "--resolution"},
    {"--depth", "--max-depth"},   {"--camera", "--lookat"},
    {"--out", "--output"},        {"-j", "--nthreads"},
    {"-t", "--nthreads"},         {"-s", "--spp"},
    {"--denoiser", "--denoise"},  {"--aov", "--aovs"},
};

// The apps from `drc` to the subcommand that was reached.
std::vector<const CLI::App*> reached(const CLI::App& app) {
    std::vector<const CLI::App*> path{&app};
    for (;;) {
        const auto chosen = path.back()->get_subcommands();
        if (chosen.empty()) return path;
        path.push_back(chosen.front());
    }
}

std::string nameOf(const std::vector<const CLI::App*>& path) {
    std::string name;
    for (const CLI::App* app : path) name += (name.empty() ? "" : " ") + app->get_name();
    return name;
}

bool looksLikeOption(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

std::vector<std::string> namesOfOptions(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

std::vector<std::string> namesOfCommands(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

std::string nearest(const std::string& word, const std::vector<std::string>& names) {
    return suggestion(word, {names.begin(), names.end()});
}

std::string unknownOption(const std::vector<const CLI::App*>& path, size_t level, const std::string& word) {
    const CLI::App& app = *path[level];
    const std::string option = word.substr(0, word.find('='));
    const std::vector<const CLI::App*> upTo(path.begin(), path.begin() + std::ptrdiff_t(level) + 1);
    const std::vector<std::string> names = namesOfOptions(app);
    std::string hint = nearest(option, names);
    for (const auto& [theirs, ours] : kElsewhere)
        if (option == theirs && std::ranges::count(names, ours) > 0) hint = fmt::format("; did you mean '{}'?", ours);
    if (level + 1 < path.size() && std::ranges::count(namesOfOptions(*path.back()), option) > 0)
        hint = fmt::format("; it belongs after the command: {} ... {}", nameOf(path), option);
    const std::string name = nameOf(upTo);
    return fmt::format("{} has no option '{}'{}{}", name, option, hint,
                       hint.empty() ? "; " + name + " --help lists them" : "");
}

std::string unknownCommand(const std::vector<const CLI::App*>& path, const std::string& word) {
    const std::string name = nameOf(path);
    std::error_code ignored;
    if (path.size() == 1 && (word.find(".pbrt") != std::string::npos || std::filesystem::exists(word, ignored)))
        return fmt::format("a command comes before the scene: drc render {}", word);
    const std::vector<std::string> names = namesOfCommands(*path.back());
    const std::string hint = nearest(word, names);
    return fmt::format("{} has no command '{}'{}", name, word,
                       hint.empty() ? fmt::format("; it has {}", fmt::join(names, ", ")) : hint);
}

// The first option that no app on the path has; empty if there is none.
std::string unknownOption(const std::vector<const CLI::App*>& path) {
    for (size_t level = 0; level < path.size(); ++level) {
        const std::vector<std::string> words = path[level]->remaining();
        const auto option = std::ranges::find_if(words, looksLikeOption);
        if (option != words.end()) return unknownOption(path, level, *option);
    }
    return "";
}

// The first word that is neither a command, nor a file that the command takes, nor a value; empty if there is none.
std::string unknownWord(const std::vector<const CLI::App*>& path) {
    const std::vector<std::string> words = path.back()->remaining();
    if (words.empty()) return "";
    if (!namesOfCommands(*path.back()).empty()) return unknownCommand(path, words.front());
    return fmt::format("'{}' is one file too many for {}", words.front(), nameOf(path));
}

std::string missing(const std::vector<const CLI::App*>& path, const CLI::RequiredError& error) {
    const std::string name = nameOf(path);
    const std::vector<std::string> commands = namesOfCommands(*path.back());
    if (!commands.empty()) return fmt::format("{} needs a command: {}", name, fmt::join(commands, ", "));
    return fmt::format("{0}: {1}; {0} --help says more", name, error.what());
}

// The error's message begins with the name of the option that has too few or too many values.
std::string wrongCount(const std::vector<const CLI::App*>& path, const CLI::ArgumentMismatch& error) {
    const std::string text = error.what();
    const CLI::Option* option = path.back()->get_option_no_throw(text.substr(0, text.find(':')));
    if (option == nullptr || option->get_positional()) return nameOf(path) + ": " + text;
    const int count = option->get_items_expected_min();
    const std::string type = option->get_type_name();  // "INT:INT in [1, 4]" if a check has a name too
    return fmt::format("{}: {} needs {}: {}", nameOf(path), option->get_name(),
                       count == 1 ? "a value" : fmt::format("{} values", count), type.substr(type.find(':') + 1));
}

// A repeated option overrides the earlier one, unless the option is a list.
void letTheLastCount(CLI::Option& option) {
    if (option.get_expected_max() == 1 && option.get_multi_option_policy() == CLI::MultiOptionPolicy::Throw)
        option.multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

// Refuses two values that are most likely mistakes: the name of an option (a value was forgotten), and an empty text (a
// script's variable is not set).
void refuseForgottenValues(const CLI::App& app, CLI::Option& option) {
    option.transform(CLI::Validator(
        [&app](std::string& text) -> std::string {
            if (text.empty()) return "the value is empty";
            if (!looksLikeOption(text)) return "";
            const std::vector<std::string> names = namesOfOptions(app);
            if (std::ranges::count(names, text.substr(0, text.find('='))) == 0) return "";
            return fmt::format("a value is missing before {}", text);
        },
        ""));
}

void applyCommonRules(CLI::App& app) {
    for (CLI::Option* option : app.get_options()) {
        if (option->get_positional() || option->get_items_expected_max() == 0) continue;
        letTheLastCount(*option);
        refuseForgottenValues(app, *option);
    }
    for (CLI::App* command : app.get_subcommands({})) applyCommonRules(*command);
}

}  // namespace

std::unique_ptr<CLI::App> makeCommandLine() {
    auto app = std::make_unique<CLI::App>(kIntroduction, "drc");
    app->set_version_flag("--version", "drc " DRC_VERSION);
    app->require_subcommand(1);
    app->footer(
        "drc SUBCOMMAND --help lists the options of a subcommand; a repeated option overrides the one before, but for\n"
        "those that are lists. Exit status: 0 done; 1 an error in a file or of the machine; 64 a command line that\n"
        "cannot be meant; 128 + the signal's number, interrupted.");
    addRenderCommand(*app);
    addViewCommand(*app);
    addCompareCommand(*app);
    addImageCommand(*app);
    addCellsCommand(*app);
    addInfoCommand(*app);
    addExportCommand(*app);
    addReferenceCommand(*app);
    addEvaluateCommand(*app);
    addBenchCommand(*app);
    applyCommonRules(*app);
    return app;
}

std::string usageFault(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<const CLI::App*> path = reached(app);
    // Help for a command that does not exist would be the help of another one.
    if (error.get_exit_code() == 0 && (path.size() > 1 || app.remaining().empty())) return "";
    if (const std::string option = unknownOption(path); !option.empty()) return option;
    if (const auto* mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return wrongCount(path, *mismatch);
    const auto* required = dynamic_cast<const CLI::RequiredError*>(&error);
    const bool isComplete =
        error.get_exit_code() == 0 || required != nullptr || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
    if (const std::string word = isComplete ? unknownWord(path) : ""; !word.empty()) return word;
    if (required != nullptr) return missing(path, *required);
    std::string text = error.what();
    std::ranges::replace(text, '\n', ' ');
    return nameOf(path) + ": " + text;
}

int finishUnparsed(const CLI::App& app, const CLI::ParseError& error) {
    const std::string fault = usageFault(app, error);
    if (fault.empty()) return app.exit(error);
    if (reached(app).size() == 1 && app.remaining().empty()) std::cerr << app.help() << "\n";
    logError(fault);
    return kUsageExitStatus;
}

}  // namespace drc
