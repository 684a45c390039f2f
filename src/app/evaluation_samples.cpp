#include "app/evaluation_samples.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/map_pictures.h"
#include "report/html_page.h"

namespace drc {
namespace {

constexpr double kErrorPercentile = 0.95;
constexpr size_t kMethodsAtFullSize = 4;  // with more methods, the pictures are smaller

std::string image(const Image& linear, const std::string& what, const char* style = "") {
    return fmt::format("<img {}src=\"{}\" alt=\"{}\"/>\n", style, pngDataUri(linear), escapeHtml(what));
}

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

std::string methodColumn(const std::string& name, const DenoisedMap& map, const MapLayout& layout, float exposure,
                         float white) {
    const std::string escaped = escapeHtml(name);
    const auto score = [](const char* title, double value) {
        return fmt::format("<dt>{}</dt><dd>{}</dd>", title, htmlNumber(value));
    };
    return fmt::format("<figure><div title=\"{0}\">{0}</div>\n", escaped) +
           image(radiancePicture(map.radiance, layout, exposure), name) +
           image(errorPicture(map.errors, layout, white), "error of " + name) + "<dl>" + score("L1", map.scores.l1) +
           score("SSIM", map.scores.ssim) + score("irradiance", map.scores.irradiance) + "</dl>\n</figure>\n";
}

std::string exampleBlock(const EvaluatedGroup& group, const ExampleKey& key, const std::string& scale) {
    TrainingExample example;
    group.files[key.file].source->load(key.index, 0, 1, example);
    const MapLayout& layout = group.layout;
    const std::vector<DenoisedMap> maps = denoiseAll(group, example);
    const float exposure = exposureOf(example.target, layout), white = errorWhite(maps);
    std::string block = fmt::format(
        "<div class=\"example\">\n<h4>{} <span>viewpoint {}, pixel {:.0f}, {:.0f}</span></h4>\n"
        "<div class=\"maps\" style=\"--map: {}px\">\n",
        escapeHtml(group.scene(key)), key.viewpoint, std::floor(key.film.x), std::floor(key.film.y),
        maps.size() > kMethodsAtFullSize ? 128 : 160);
    block += "<figure><div>distance</div>\n" + image(distancePicture(example.inputs.front(), layout), "distance") +
             image(normalPicture(example.inputs.front(), layout), "normals") + "<div>normals</div></figure>\n";
    if (group.guides)
        block += "<figure><div>albedo</div>\n" +
                 image(radiancePicture(example.inputs.front().albedo, layout, 1), "albedo") + "</figure>\n";
    for (size_t m = 0; m < maps.size(); ++m)
        block += methodColumn(m == 0 ? group.methods[m].name + ": 1 sample a texel" : group.methods[m].name, maps[m],
                              layout, exposure, white);
    block += "<figure><div>reference</div>\n" + image(radiancePicture(example.target, layout, exposure), "reference") +
             scale +
             fmt::format(
                 "<div class=\"ends\"><span>0</span><span>{:.2f}</span></div>\n"
                 "<div>error, in means</div><div>of the reference</div></figure>\n",
                 white);
    return block + "</div>\n</div>\n";
}

}  // namespace

std::string sampleMaps(const EvaluatedGroup& group, const std::vector<size_t>& chosen) {
    const std::string scale = image(errorScale(), "scale of the error", "class=\"bar\" ");
    std::string blocks;
    for (const size_t i : chosen) blocks += exampleBlock(group, group.examples[i], scale);
    return blocks;
}

}  // namespace drc
