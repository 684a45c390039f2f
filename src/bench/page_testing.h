// For tests of a comparison's page: reports with given numbers and pictures.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/folder_testing.h"
#include "bench/bench_result.h"
#include "image/image_io.h"

namespace drc {

inline Budget seconds(double amount) { return {BudgetUnit::Seconds, amount}; }
inline Budget spp(double amount) { return {BudgetUnit::Spp, amount}; }
inline Budget tasks(double amount) { return {BudgetUnit::Tasks, amount}; }

// A picture that differs from that of any other seed.
inline Image testPicture(int seed, int width = 16, int height = 12) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.setRgb(x, y, Rgb(float(x) / 16, float(y) / 16, float(seed % 64) / 64));
    return image;
}

// A report that grows with the runs that are added: scenes, methods and budgets have the order in which they first
// appear.
class ReportBuilder {
  public:
    ReportBuilder() {
        report.version = "9.8.7";
        report.processor = "some processor";
        report.threads = 3;
    }

    // Adds a run that took as long as its budget in seconds, or one second. The result may be changed, and is valid
    // until the next run is added.
    BenchRun& add(const std::string& scene, const std::string& method, const Budget& budget, double error,
                  double ssim = 0.5) {
        if (std::none_of(report.scenes.begin(), report.scenes.end(), [&](const auto& s) { return s.name == scene; })) {
            BenchScene added;
            added.name = scene;
            added.file = "scene.pbrt";
            added.referenceOrigin = "given";
            added.width = 16, added.height = 12;
            added.reference = picture();
            report.scenes.push_back(added);
        }
        include(report.methods, method);
        include(report.budgets, budget);
        BenchRun run;
        run.scene = scene, run.method = method, run.budget = budget;
        run.repeat = int(std::count_if(report.runs.begin(), report.runs.end(), [&](const BenchRun& r) {
            return r.scene == scene && r.method == method && r.budget == budget;
        }));
        run.seconds = budget.unit == BudgetUnit::Seconds ? budget.amount : 1;
        run.cpuSeconds = 2 * run.seconds;
        run.peakMegabytes = 100;
        run.error = error, run.ssim = ssim, run.flip = error / 2;
        run.pngKb = 10;
        run.picture = picture();
        report.runs.push_back(run);
        return report.runs.back();
    }
    void addFailure(const std::string& scene, const std::string& method, const Budget& budget,
                    const std::string& failure) {
        BenchRun& run = add(scene, method, budget, kNotMeasured, kNotMeasured);
        run.failure = failure;
        run.picture.clear();
    }

    // Writes a picture that no other run has, and returns its name.
    std::string picture() {
        const std::string name = "picture-" + std::to_string(++pictures_) + ".exr";
        writeExr(folder.path(name), testPicture(pictures_));
        return name;
    }

    TemporaryFolder folder;
    BenchReport report;

  private:
    static void include(auto& list, const auto& item) {
        if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
    }
    int pictures_ = 0;
};

// The text from the first occurrence of `from` to the next one of `to`; empty if there is none.
inline std::string between(const std::string& text, const std::string& from, const std::string& to) {
    const size_t begin = text.find(from), end = text.find(to, begin == std::string::npos ? begin : begin + from.size());
    return begin == std::string::npos || end == std::string::npos ? "" : text.substr(begin, end - begin);
}

}  // namespace drc
