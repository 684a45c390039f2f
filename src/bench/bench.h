// Scenes x methods x budgets: each a process of its own, measured, its picture compared with the scene's references.
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
    std::vector<BenchMethod> methods;  // of different names
    std::vector<Budget> budgets;       // a method is left out of those that it does not keep
    int repeats = 1;                   // each with a seed of its own, from 0
    std::string output;                // folder, made if need be: runs/ and references/ in it
    std::string references;            // folder (scene_references.h); empty: they are rendered
    ReferenceSettings reference;
    int width = 0, height = 0;   // 0: the references' if they are given, else 1280x720
    int threads = 0;             // at least 1
    double limitSeconds = 3600;  // of a run that is to keep no seconds
    OwnProgram own;
};

// A scene's name: its file's, without extension; its folder's if the file is called "scene".
std::string sceneName(const std::string& file);

// Runs what there is no result of yet in settings.output and returns all. A result counts for as long as the command,
// the program (ours: drc itself) and the scene's file stay as they were; where references have changed, its picture is
// measured anew. Repeats are the outermost loop and methods the
// innermost, so that methods that are compared run side by side. A method that fails leaves a BenchRun with what it
// said, and is tried again the next time. Stops early on `cancel`, with what is done so far. Throws Error on what makes
// all of it pointless: a scene or a reference that cannot be read, an external program that is not installed, two
// scenes of one name.
BenchReport runBench(const BenchSettings& settings, const CancelToken* cancel);

}  // namespace drc
