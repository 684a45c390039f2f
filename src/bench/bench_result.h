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

// One process, and how far its picture is from the references. NaN: not measured, or not defined.
struct BenchRun {
    std::string scene, method;
    Budget budget;
    int repeat = 0;  // from 0; its seed

    std::string failure;                  // one line; empty if there is a picture. Then all below means nothing
    std::string picture;                  // EXR, linear; relative to the folder of the report
    std::string oidnMode;                 // what Open Image Denoise was asked for (oidn_mode.h); empty: nothing
    std::string measuredAgainst;          // state of the references' files
    double seconds = kNotMeasured;        // wall clock of the whole process
    double cpuSeconds = kNotMeasured;     // of all threads and child processes, user and system
    double peakMegabytes = kNotMeasured;  // largest resident set, in units of 10^6 bytes
    // Parts of `seconds` and samples a pixel, where the program tells.
    double loadSeconds = kNotMeasured, renderSeconds = kNotMeasured, denoiseSeconds = kNotMeasured,
           writeSeconds = kNotMeasured, spp = kNotMeasured;

    // Against a pair of references: CrossErrors (image/cross_error.h), with standard errors. Against a single one:
    // relMSE (image/relmse.h) of pixels and of blocks, with the reference's noise in them; no trimmed error, no
    // standard errors.
    double error = kNotMeasured, errorSe = kNotMeasured;
    double trimmedError = kNotMeasured, trimmedErrorSe = kNotMeasured;
    double blockError = kNotMeasured, blockErrorSe = kNotMeasured;
    double ssim = kNotMeasured, flip = kNotMeasured;  // against the reference, or the mean of both
    double pngKb = kNotMeasured;                      // of the 8-bit sRGB picture, in units of 1000 bytes
    double entropy = kNotMeasured;                    // of its luminance's 256 levels, in bits a pixel
    std::array<double, 3> meanRatio{kNotMeasured, kNotMeasured, kNotMeasured};  // R, G, B: picture / reference
};

struct BenchScene {
    std::string name, file;
    // EXR; relative to the folder of the report, or absolute. `reference` is what is shown: of a pair the mean.
    std::string reference;
    std::vector<std::string> pair;  // two independent references; empty if there is only one
    std::string referenceOrigin;    // how they came to be, for the page: "given", or what rendered them
    int width = 0, height = 0;
    double referencePngKb = kNotMeasured, referenceEntropy = kNotMeasured;
    double referenceNoise = kNotMeasured;  // of each of a pair, in the norm of the errors
    // How far the noise of a pair's mean puts a perfect picture from SSIM 1 and FLIP 0.
    double ssimNoise = kNotMeasured, flipNoise = kNotMeasured;
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

// The opponent that others are measured by: path tracing with Open Image Denoise in whichever mode.
inline constexpr const char* kOpponent = "path+oidn";
// The smallest median error of the methods that are this opponent. NaN: none was run.
double opponentError(const BenchReport& report, const std::string& scene, const Budget& budget);

}  // namespace drc
