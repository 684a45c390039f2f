// Code shared by the subcommands. Each subcommand is a source file that registers itself with CLI11. Its callback does
// the work; it throws drc::UsageError for an invalid command line, and drc::Error for any other fault that the user can
// fix.
#pragma once
#include <CLI/CLI.hpp>
#include <chrono>
#include <string>
#include <vector>

#include "scene/cameras/camera.h"

namespace drc {

// The start of the process, to about 10 ms, and its command line, which main sets before anything else.
struct ProcessInfo {
    std::chrono::steady_clock::time_point start;
    std::string commandLine;
};
ProcessInfo& processInfo();

// Parses a resolution such as "1280x720". Throws UsageError, naming --resolution, on anything else.
FilmGeometry parseResolution(const std::string& text);

// The name of a scene for messages: files are often called "scene.pbrt", so the folder is part of it.
std::string sceneTitle(const std::string& path);

void addRenderCommand(CLI::App& app);
void addInfoCommand(CLI::App& app);
void addExportCommand(CLI::App& app);
void addReferenceCommand(CLI::App& app);
void addEvaluateCommand(CLI::App& app);
void addBenchCommand(CLI::App& app);
void addViewCommand(CLI::App& app);
void addImageCommand(CLI::App& app);
void addCellsCommand(CLI::App& app);

// `drc bench` is a command of the laboratory (laboratory.h), which parses its arguments by itself.
inline constexpr const char* kBenchCommand = "bench";
bool isBench(int argc, const char* const* argv);
// Replaces this process by it. Throws Error if it cannot be started.
[[noreturn]] void bench(int argc, const char* const* argv);

}  // namespace drc
