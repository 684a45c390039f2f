// Compares methods: scenes x methods x budgets, each in a process of its own that is measured, and each picture
// compared with the scene's references.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "bench/bench_method.h"
#include "bench/bench_reference.h"
#include "bench/bench_result.h"

namespace drc {

struct BenchSettings {
    std::vector<std::string> scenes;   // files
    std::vector<BenchMethod> methods;  // with different names
    std::vector<Budget> budgets;       // a method is left out of budgets that it cannot keep
    int repeats = 1;                   // each with a seed of its own, from 0
    std::string output;                // folder, created if need be, with runs/ and references/
    std::string references;            // folder (scene_references.h); empty: they are rendered
    ReferenceSettings reference;
    int width = 0, height = 0;   // 0: the references' if they are given, else 1280x720
    int threads = 0;             // at least 1
    double limitSeconds = 3600;  // of a run without a budget in seconds
    OwnProgram own;
};

// The name of a scene: that of its file without extension, or of its folder if the file is called "scene".
std::string sceneName(const std::string& file);

// Runs everything that has no result in settings.output yet, and returns all results. A result is valid as long as the
// command, the program (ours: drc itself) and the scene's file are unchanged; if references have changed, its picture
// is measured again. Repeats are the outermost loop and methods the innermost, so that methods that are compared run
// side by side. A method that fails leaves a BenchRun with its message, and is tried again the next time. Stops early
// on `cancel`, and returns the results so far. Throws Error if the whole comparison makes no sense: a scene or a
// reference cannot be read, an external program is not installed, or two scenes have one name.
BenchReport runBench(const BenchSettings& settings, const CancelToken* cancel);

}  // namespace drc
