#include "pbrt/render_settings_params.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/limits.h"
#include "base/log.h"
#include "base/suggest.h"
#include "scene/crop_window.h"

namespace drc::pbrt {
int positiveOf(const ParamSet& params, std::string_view name, int fallback, int most) {
    const int value = params.getInt(name, fallback);
    if (value < 1 || value > most)
        params.failAt(*params.find(name, {ParamType::Integer}),
                      "must be from 1 to " + std::to_string(most) + ", not " + std::to_string(value));
    return value;
}

void checkKnown(const std::vector<std::string_view>& known, const std::string& kind, const std::string& name,
                const SourcePos& pos) {
    if (std::find(known.begin(), known.end(), name) == known.end())
        fail(pos, "unknown " + kind + " '" + name + "'" + suggestion(name, known));
}

void applyFrame(const ParamSet& params, RenderSettings& settings) {
    settings.film.width = positiveOf(params, "xresolution", settings.film.width, limits::kFilmSide);
    settings.film.height = positiveOf(params, "yresolution", settings.film.height, limits::kFilmSide);
    settings.filmAt = params.pos().location();
    if (const Param* file = params.findFile("filename")) {
        settings.outputFile = file->strings[0];
        settings.outputFileAt = file->pos.location();
    }
    settings.film.diagonal = params.getPositiveFloat("diagonal", settings.film.diagonal);
    if (const Param* window = params.find("cropwindow", {ParamType::Float})) {
        try {
            const CropWindow crop = cropWindowOf(window->numbers);
            std::copy(crop.begin(), crop.end(), settings.cropWindow);
        } catch (const Error& error) {
            params.failAt(*window, error.what());
        }
    }
}

void applyPixelBounds(const ParamSet& params, RenderSettings& settings) {
    const Param* bounds = params.find("pixelbounds", {ParamType::Integer});
    if (bounds == nullptr) return;
    if (bounds->numbers.size() != 4) params.failAt(*bounds, "must have four values of type 'integer'");
    PixelRegion& r = settings.pixelBounds.emplace();
    r = {int(bounds->numbers[0]), int(bounds->numbers[2]), int(bounds->numbers[1]), int(bounds->numbers[3])};
    if (r.x0 >= r.x1 || r.y0 >= r.y1)
        params.failAt(*bounds, "is empty: it must be x0 x1 y0 y1 in pixels, with x0 < x1 and y0 < y1");
}

int samplesOfStratified(const ParamSet& params) {
    const int64_t samples = int64_t(positiveOf(params, "xsamples", 4, 4096)) * positiveOf(params, "ysamples", 4, 4096);
    return int(std::min<int64_t>(samples, limits::kSamplesPerPixel));
}

int maxDepthOf(const ParamSet& params) {
    const int depth = params.getInt("maxdepth", 5);
    if (depth < 0) params.failAt(*params.find("maxdepth", {ParamType::Integer}), "must not be negative");
    return depth;
}

void acceptChoiceOfLights(const ParamSet& params, std::string_view name, const std::vector<std::string_view>& known,
                          const std::string& integrator) {
    const std::string choice = params.getString(name, "");
    const Param* param = params.find(name, {ParamType::String});
    if (param == nullptr) return;
    checkKnown(known, std::string(name), choice, param->valuePos);
    logDebug(fmt::format("integrator '{}': lights are chosen by what they can bring to a point, not by '{}'",
                         integrator, choice));
}

void acceptKnobs(const IntegratorKnobs& all, const std::string& type, const ParamSet& params) {
    const auto knobs = all.find(type);
    if (knobs == all.end()) {
        params.ignoreAll();
        return;
    }
    for (const std::string_view name : knobs->second) {
        if (!params.has(name)) continue;
        params.ignore({name});
        logDebug(fmt::format("integrator '{}': '{}' has no effect", type, name));
    }
    params.warnUnused();
}

}  // namespace drc::pbrt
