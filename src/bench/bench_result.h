// What a comparison of renderers measured: plain data, as `drc bench` keeps it and its page shows it.
#pragma once
#include <array>
#include <limits>
#include <string>
#include <vector>

namespace drc {

// What a method may spend: wall-clock seconds of its whole process, or so much of its own unit.
enum class BudgetUnit { Seconds, Spp, Tasks };

struct Budget {
    BudgetUnit unit = BudgetUnit::Seconds;
    double amount = 0;

    bool operator==(const Budget&) const = default;
};

// "30 s", "16 spp", "16 tasks".
std::string budgetName(const Budget& budget);

inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

// One process, and how far its picture is from the reference. NaN: not measured, or not defined.
struct BenchRun {
    std::string scene, method;
    Budget budget;
    int repeat = 0;  // from 0; its seed

    std::string failure;                  // one line; empty if there is a picture. Then all below means nothing
    std::string picture;                  // EXR, linear; relative to the folder of the report
    double seconds = kNotMeasured;        // wall clock of the whole process: reading, rendering, denoising, writing
    double renderSeconds = kNotMeasured;  // of rendering alone, where the program tells
    double cpuSeconds = kNotMeasured;     // of all threads and child processes, user and system
    double peakMegabytes = kNotMeasured;  // largest resident set, in units of 10^6 bytes

    double ssim = kNotMeasured, flip = kNotMeasured, relmse = kNotMeasured, mse = kNotMeasured;
    double pngKb = kNotMeasured;    // of the 8-bit sRGB picture, in units of 1000 bytes
    double entropy = kNotMeasured;  // of its luminance's 256 levels, in bits a pixel
    std::array<double, 3> meanRatio{kNotMeasured, kNotMeasured, kNotMeasured};  // R, G, B: picture / reference
};

struct BenchScene {
    std::string name, file;
    std::string reference;        // EXR; relative to the folder of the report, or absolute
    std::string referenceOrigin;  // how it came to be, for the page: "given", or what rendered it
    int width = 0, height = 0;
    double referencePngKb = kNotMeasured, referenceEntropy = kNotMeasured;
};

struct BenchReport {
    std::string version, processor;
    int threads = 0;
    std::vector<BenchScene> scenes;
    std::vector<std::string> methods;  // in the order in which they were asked for
    std::vector<Budget> budgets;       // the same
    std::vector<BenchRun> runs;
};

// Of one quantity over the repeats of a run.
struct BenchSpread {
    int count = 0;
    double median = kNotMeasured;
    // Between these the true median lies with at least 95 % where six or more repeats allow it (order statistics,
    // whatever the distribution); with fewer they are the smallest and the largest value.
    double low = kNotMeasured, high = kNotMeasured;
};
BenchSpread spreadOf(std::vector<double> values);

// The runs of these that worked.
std::vector<const BenchRun*> runsOf(const BenchReport& report, const std::string& scene, const std::string& method,
                                    const Budget& budget);

}  // namespace drc
