// The results of a comparison of renderers: plain data that `drc bench` stores and its page shows.
#pragma once
#include <array>
#include <limits>
#include <string>
#include <vector>

namespace drc {

// The budget of a method: wall-clock seconds of its whole process, or an amount in its own unit.
enum class BudgetUnit { Seconds, Spp, Tasks };

struct Budget {
    BudgetUnit unit = BudgetUnit::Seconds;
    double amount = 0;

    bool operator==(const Budget&) const = default;
};

// "30 s", "16 spp", "16 tasks".
std::string budgetName(const Budget& budget);

inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

// One process and the errors of its picture. NaN: not measured, or not defined.
struct BenchRun {
    std::string scene, method;
    Budget budget;
    int repeat = 0;  // from 0; also the seed

    std::string failure;                  // one line; empty if there is a picture. If not empty, nothing below is valid
    std::string picture;                  // EXR, linear; relative to the folder of the report
    std::string oidnMode;                 // the mode of Open Image Denoise (oidn_mode.h); empty: not used
    std::string measuredAgainst;          // the state of the references' files
    double seconds = kNotMeasured;        // wall clock of the whole process
    double cpuSeconds = kNotMeasured;     // of all threads and child processes, user and system
    double peakMegabytes = kNotMeasured;  // largest resident set, in units of 10^6 bytes
    // Parts of `seconds`, and samples a pixel, if the program reports them.
    double loadSeconds = kNotMeasured, renderSeconds = kNotMeasured, denoiseSeconds = kNotMeasured,
           writeSeconds = kNotMeasured, spp = kNotMeasured;

    // Against a pair of references: CrossErrors (image/cross_error.h) with standard errors. Against a single one:
    // relMSE (image/relmse.h) of pixels and of blocks, which includes the reference's noise; no trimmed error, no
    // standard errors.
    double error = kNotMeasured, errorSe = kNotMeasured;
    double trimmedError = kNotMeasured, trimmedErrorSe = kNotMeasured;
    double blockError = kNotMeasured, blockErrorSe = kNotMeasured;
    double ssim = kNotMeasured, flip = kNotMeasured;  // against the reference, or the mean of the pair
    double pngKb = kNotMeasured;                      // of the 8-bit sRGB picture, in units of 1000 bytes
    double entropy = kNotMeasured;                    // of its luminance's 256 levels, in bits a pixel
    std::array<double, 3> meanRatio{kNotMeasured, kNotMeasured, kNotMeasured};  // R, G, B: picture / reference
};

struct BenchScene {
    std::string name, file;
    // EXR; relative to the folder of the report, or absolute. `reference` is shown on the page: for a pair it is the
    // mean.
    std::string reference;
    std::vector<std::string> pair;  // two independent references; empty if there is only one
    std::string referenceOrigin;    // their origin, for the page: "given", or how they were rendered
    int width = 0, height = 0;
    double referencePngKb = kNotMeasured, referenceEntropy = kNotMeasured;
    double referenceNoise = kNotMeasured;  // of each reference of a pair, in the norm of the errors
    // How far a perfect picture is from SSIM 1 and FLIP 0, because of the noise of the pair's mean.
    double ssimNoise = kNotMeasured, flipNoise = kNotMeasured;
};

struct BenchReport {
    std::string version, processor;
    int threads = 0;
    std::vector<BenchScene> scenes;
    std::vector<std::string> methods;  // in the order in which they were asked for
    std::vector<Budget> budgets;       // also in that order
    std::vector<BenchRun> runs;
};

// The spread of one quantity over the repeats of a run.
struct BenchSpread {
    int count = 0;
    double median = kNotMeasured;
    // An interval that contains the true median with a probability of at least 95 % if there are six or more repeats
    // (order statistics, for any distribution); with fewer, the smallest and the largest value.
    double low = kNotMeasured, high = kNotMeasured;
};
BenchSpread spreadOf(std::vector<double> values);

// The successful runs of this scene, method and budget.
std::vector<const BenchRun*> runsOf(const BenchReport& report, const std::string& scene, const std::string& method,
                                    const Budget& budget);

// The opponent that other methods are compared with: path tracing with Open Image Denoise in any mode.
inline constexpr const char* kOpponent = "path+oidn";
// The smallest median error of the methods that are this opponent. NaN: there was none.
double opponentError(const BenchReport& report, const std::string& scene, const Budget& budget);

}  // namespace drc
