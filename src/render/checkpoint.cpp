#include "render/checkpoint.h"

#include <fmt/core.h>

#include <cstdlib>

#include "base/error.h"
#include "base/regular_file.h"

namespace drc {
namespace {

constexpr const char* kCheckpointKind = "drc render";

}  // namespace

Identity identityOf(const RenderSettings& settings, const RenderParams& params, const Identity& others) {
    const FilmGeometry& film = settings.film;
    const PixelRegion region = settings.region();
    Identity identity{{"version", DRC_VERSION},
                      {"integrator", params.integrator},
                      {"film", fmt::format("{} x {} pixels", film.width, film.height)},
                      {"part of the film", fmt::format("{} {} {} {}", region.x0, region.y0, region.x1, region.y1)},
                      {"--seed", std::to_string(params.seed)},
                      {"first sample", std::to_string(params.firstSample)},
                      {"--max-depth", std::to_string(*params.maxDepth)},
                      {"--clamp", fmt::format("{}", params.clamp)},
                      {"guiding", params.guide ? "on" : "off"},
                      {"layers", fmt::format("{}{}{}{}{}", params.gBuffer ? "G-buffer " : "",
                                             params.parts ? "parts " : "", params.variance ? "variance" : "",
                                             params.independentHalves ? " of independent halves" : "",
                                             params.surfaces ? " surfaces" : "")}};
    if (params.frame != 0) identity.emplace_back("--frame", std::to_string(params.frame));
    if (traitsOf(params.integrator).cells)
        identity.insert(identity.end(), {{"--cells", params.cells ? "on" : "off"},
                                         {"--cell-size", fmt::format("{}", params.cellSize)}});
    identity.insert(identity.end(), others.begin(), others.end());
    return identity;
}

Identity checkpointFiles(const Scene& scene) {
    if (scene.files.empty() || !isRegularFile(scene.files[0]))
        throw Error("--checkpoint, --resume: a scene that comes through a pipe cannot be read again; give its file");
    return identityOfFiles(scene);
}

void Checkpoint::save(const Session& session, const std::string& path) const {
    session.save(path, identityLine(identity_));
}

Identity Checkpoint::identityOf(const std::string& path) { return identityIn(path, kCheckpointKind); }

void Checkpoint::resume(Session& session, const std::string& path) const {
    requireIdentity("--resume " + path, identityOf(path), identity_);
    session.load(path, identityLine(identity_));
}

std::chrono::duration<double> durationOf(const std::string& option, const std::string& text) {
    const size_t end = text.find_first_not_of("0123456789.");
    const std::string number = text.substr(0, end), unit = end == std::string::npos ? "s" : text.substr(end);
    const double seconds = unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
    char* rest = nullptr;
    const double value = std::strtod(number.c_str(), &rest);
    if (seconds == 0 || number.empty() || *rest != '\0' || !(value * seconds >= 1) || !(value * seconds < 1e9))
        throw Error(option + " " + text + ": must be a time of a second or more, as 60, 60s, 5m or 1h");
    return std::chrono::duration<double>(value * seconds);
}

}  // namespace drc
