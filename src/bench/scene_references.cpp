#include "bench/scene_references.h"

#include <fmt/core.h>

#include <filesystem>

#include "base/error.h"
#include "image/entropy.h"
#include "image/image_io.h"
#include "image/metrics.h"

namespace drc {

std::vector<std::string> givenReferences(const std::string& folder, const std::string& name) {
    const auto path = [&](const char* suffix) {
        return std::filesystem::absolute(std::filesystem::path(folder) / (name + suffix)).lexically_normal().string();
    };
    const std::string single = path(".exr"), first = path("-1.exr"), second = path("-2.exr");
    const bool hasFirst = std::filesystem::exists(first), hasSecond = std::filesystem::exists(second);
    if (hasFirst && hasSecond) return {first, second};
    if (hasFirst || hasSecond)
        throw Error(fmt::format("{} is there, but not {}: a pair of references needs both", hasFirst ? first : second,
                                hasFirst ? second : first));
    if (std::filesystem::exists(single)) return {single};
    throw Error(
        fmt::format("--references {}: there is neither {}.exr nor {}-1.exr with {}-2.exr", folder, name, name, name));
}

SceneReferences::SceneReferences(const std::vector<std::string>& paths) {
    if (paths.size() == 2)
        pair_.emplace(readLinearRgb(paths[0]), readLinearRgb(paths[1]), 0.f, paths[0], paths[1]);
    else
        single_ = readLinearRgb(paths.at(0));
}

void SceneReferences::describe(BenchScene& scene) const {
    scene.referencePngKb = double(encodePng(shown()).size()) / 1000;
    scene.referenceEntropy = luminanceEntropy(shown());
    if (!pair_) return;
    scene.ssimNoise = pair_->ssimNoise(), scene.flipNoise = pair_->flipNoise();
    scene.referenceNoise = referenceNoise(pair_->first(), pair_->second(), pair_->norm());
}

void SceneReferences::measure(const std::string& path, BenchRun& run) const {
    const Image picture = readLinearRgb(path);
    if (picture.width() != shown().width() || picture.height() != shown().height())
        throw Error(fmt::format("wrote {} pixels, not {}", sizeString(picture), sizeString(shown())));
    run.entropy = luminanceEntropy(picture);
    if (!pair_) {
        const Metrics m = compare(single_, picture);
        run.error = m.relmse, run.blockError = m.blockRelmse;
        run.ssim = m.ssim, run.flip = m.flip;
        run.pngKb = m.pngKb[1];
        run.meanRatio = m.meanRatio;
        return;
    }
    const PairMetrics m = pair_->compare(picture, path);
    run.error = m.errors.error.mean, run.errorSe = m.errors.error.standardError;
    run.trimmedError = m.errors.trimmed.mean, run.trimmedErrorSe = m.errors.trimmed.standardError;
    run.blockError = m.errors.block.mean, run.blockErrorSe = m.errors.block.standardError;
    run.ssim = m.ssim, run.flip = m.flip;
    run.pngKb = m.pngKb[1];
    run.meanRatio = m.errors.meanRatio;
}

}  // namespace drc
