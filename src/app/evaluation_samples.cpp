#include "app/evaluation_samples.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/map_pictures.h"
#include "image/image_io.h"

namespace drc {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kErrorPercentile = 0.95;

struct DenoisedMap {
    std::vector<float> radiance, errors;
    MapScores scores;
};

// The upper end of the false colours: the error that one texel in twenty exceeds, over all methods but the first. The
// captured map's own errors are so large that the differences between the others would not be visible.
float errorWhite(const std::vector<DenoisedMap>& maps) {
    std::vector<float> pooled;
    for (size_t m = 1; m < maps.size(); ++m) pooled.insert(pooled.end(), maps[m].errors.begin(), maps[m].errors.end());
    std::sort(pooled.begin(), pooled.end());
    const float white = pooled[size_t(kErrorPercentile * double(pooled.size() - 1))];
    return white > 0 ? white : 1;
}

std::vector<DenoisedMap> denoiseAll(const EvaluatedGroup& group, const TrainingExample& example) {
    const auto unit = float(hemisphereMean(example.target, group.layout));
    std::vector<DenoisedMap> maps;
    for (const EvaluatedMethod& method : group.methods) {
        std::vector<CapturedMap> one{example.inputs.front()};
        method.mapDenoiser->denoise(one, group.layout);
        const std::vector<float>& radiance = one.front().radiance;
        maps.push_back(
            {radiance, texelErrors(radiance, example.target, unit), scoreMap(radiance, example.target, group.layout)});
    }
    return maps;
}

// JSON has no NaN, the SSIM of maps that are too small for it.
Json score(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

// Writes pictures whose names begin alike.
class MapPictureFiles {
  public:
    MapPictureFiles(std::string folder, std::string stem) : folder_(std::move(folder)), stem_(std::move(stem)) {}

    std::string write(const std::string& what, const Image& linear) const {
        const std::string name = fmt::format("{}-{}.png", stem_, what);
        writePng((std::filesystem::path(folder_) / name).string(), linear);
        return name;
    }

  private:
    std::string folder_, stem_;
};

Json sampleOf(const EvaluatedGroup& group, const ExampleKey& key, const MapPictureFiles& pictures) {
    TrainingExample example;
    group.files[key.file].source->load(key.index, 0, 1, example);
    const MapLayout& layout = group.layout;
    const CapturedMap& captured = example.inputs.front();
    const std::vector<DenoisedMap> maps = denoiseAll(group, example);
    const float exposure = exposureOf(example.target, layout), white = errorWhite(maps);
    Json sample{{"scene", group.scene(key)},
                {"viewpoint", key.viewpoint},
                {"pixel", {std::floor(key.film.x), std::floor(key.film.y)}},
                {"distance", pictures.write("distance", distancePicture(captured, layout))},
                {"normals", pictures.write("normals", normalPicture(captured, layout))}};
    if (group.guides) sample["albedo"] = pictures.write("albedo", radiancePicture(captured.albedo, layout, 1));
    sample["methods"] = Json::array();
    for (size_t m = 0; m < maps.size(); ++m) {
        const DenoisedMap& map = maps[m];
        sample["methods"].push_back(
            {{"name", group.methods[m].name},
             {"picture", pictures.write(fmt::format("{}", m), radiancePicture(map.radiance, layout, exposure))},
             {"error", pictures.write(fmt::format("{}-error", m), errorPicture(map.errors, layout, white))},
             {"l1", score(map.scores.l1)},
             {"ssim", score(map.scores.ssim)},
             {"irradiance_relmse", score(map.scores.irradiance)}});
    }
    sample["reference"] = pictures.write("reference", radiancePicture(example.target, layout, exposure));
    sample["white"] = score(white);
    return sample;
}

}  // namespace

Json writeSamples(const Evaluation& evaluation, size_t group, const SampleSettings& settings) {
    const EvaluatedGroup& shown = evaluation.groups[group];
    Json samples = Json::array();
    for (const size_t i : chooseExamples(shown, settings.count, settings.seed))
        samples.push_back(
            sampleOf(shown, shown.examples[i], MapPictureFiles(settings.folder, fmt::format("{}-{}", group, i))));
    return samples;
}

std::string writeErrorScale(const SampleSettings& settings) {
    return MapPictureFiles(settings.folder, "error").write("scale", errorScale());
}

}  // namespace drc
