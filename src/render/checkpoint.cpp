#include "render/checkpoint.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "base/checksum.h"
#include "base/error.h"
#include "base/mapped_file.h"
#include "base/parallel.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::string_view kFile = Checkpoint::kFile;
constexpr const char* kKind = "drc render";

std::string inQuotes(const std::string& value) { return value.empty() ? "nothing" : "'" + value + "'"; }

}  // namespace

Checkpoint::Identity identityOf(const RenderSettings& settings, const RenderParams& params,
                                const Checkpoint::Identity& others) {
    const FilmGeometry& film = settings.film;
    const PixelRegion region = settings.region();
    Checkpoint::Identity identity{
        {"version", DRC_VERSION},
        {"integrator", params.integrator},
        {"film", fmt::format("{} x {} pixels", film.width, film.height)},
        {"part of the film", fmt::format("{} {} {} {}", region.x0, region.y0, region.x1, region.y1)},
        {"--seed", std::to_string(params.seed)},
        {"first sample", std::to_string(params.firstSample)},
        {"--max-depth", std::to_string(*params.maxDepth)},
        {"--clamp", fmt::format("{}", params.clamp)},
        {"guiding", params.guide ? "on" : "off"},
        {"layers",
         fmt::format("{}{}{}{}", params.gBuffer ? "G-buffer " : "", params.parts ? "parts " : "",
                     params.variance ? "variance" : "", params.independentHalves ? " of independent halves" : "")}};
    if (traitsOf(params.integrator).cells)
        identity.insert(identity.end(), {{"--cells", params.cells ? "on" : "off"},
                                         {"--cell-size", fmt::format("{}", params.cellSize)}});
    identity.insert(identity.end(), others.begin(), others.end());
    return identity;
}

Checkpoint::Identity identityOfFiles(const Scene& scene) {
    std::vector<uint64_t> hashes(scene.files.size());
    const fs::path folder = scene.files.empty() ? fs::path() : fs::path(scene.files[0]).parent_path();
    std::error_code ignored;
    if (scene.files.empty() || !fs::is_regular_file(scene.files[0], ignored))
        throw Error("--checkpoint, --resume: a scene that comes through a pipe cannot be read again; give its file");
    parallelFor(0, int(hashes.size()), 1, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) hashes[size_t(i)] = checksum(MappedFile(scene.files[size_t(i)]).bytes());
    });
    Checkpoint::Identity identity;
    // Paths are relative to the scene's folder, so that the scene may be moved to another folder or another machine.
    for (size_t i = 0; i < hashes.size(); ++i) {
        const fs::path path(scene.files[i]);
        const fs::path relative = path.lexically_relative(folder);
        identity.emplace_back(std::string(kFile) + (relative.empty() ? path : relative).string(),
                              fmt::format("{:016x}", hashes[i]));
    }
    return identity;
}

std::string Checkpoint::line() const {
    Json list = Json::array();
    for (const auto& [name, value] : identity_) list.push_back({name, value});
    // Names of files need not be UTF-8.
    return list.dump(-1, ' ', true, Json::error_handler_t::replace);
}

void Checkpoint::save(const Session& session, const std::string& path) const { session.save(path, line()); }

Checkpoint::Identity Checkpoint::identityIn(const std::string& path) {
    const std::string header = stateHeader(path, kKind);
    const size_t start = header.find('[');
    const Json list = start == std::string::npos
                          ? Json()
                          : Json::parse(header.begin() + std::ptrdiff_t(start), header.end(), nullptr, false);
    Identity identity;
    if (!list.is_array()) throw Error(path + ": the file is damaged: its first line does not say what it is of");
    for (const Json& item : list) {
        if (!item.is_array() || item.size() != 2 || !item[0].is_string() || !item[1].is_string())
            throw Error(path + ": the file is damaged: its first line does not say what it is of");
        identity.emplace_back(item[0].get<std::string>(), item[1].get<std::string>());
    }
    return identity;
}

void Checkpoint::resume(Session& session, const std::string& path) const {
    std::map<std::string, std::string> theirs;
    for (const auto& [name, value] : identityIn(path)) theirs[name] = value;
    const Json mine = Json::parse(line());
    for (const Json& item : mine) {
        const std::string name = item[0].get<std::string>(), value = item[1].get<std::string>();
        const auto found = theirs.find(name);
        const bool same = found != theirs.end() && found->second == value;
        if (same) {
            theirs.erase(found);
            continue;
        }
        if (name.starts_with(kFile)) {
            const std::string file = name.substr(kFile.size());
            throw Error(found == theirs.end()
                            ? fmt::format("--resume {}: it is of a scene that does not have the file '{}'", path, file)
                            : fmt::format("--resume {}: the scene's file '{}' has changed since", path, file));
        }
        throw Error(fmt::format("--resume {}: it was made with another {}: {}, here {}", path, name,
                                inQuotes(found == theirs.end() ? "" : found->second), inQuotes(value)));
    }
    if (!theirs.empty()) {
        const std::string& name = theirs.begin()->first;
        throw Error(name.starts_with(kFile) ? fmt::format("--resume {}: it is of a scene that also has the file '{}'",
                                                          path, name.substr(kFile.size()))
                                            : fmt::format("--resume {}: it was made with {} {}, here there is none",
                                                          path, name, inQuotes(theirs.begin()->second)));
    }
    session.load(path, line());
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
