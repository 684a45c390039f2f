#include "render/identity.h"

#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "base/checksum.h"
#include "base/error.h"
#include "base/mapped_file.h"
#include "base/parallel.h"
#include "base/state_file.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string inQuotes(const std::string& value) { return value.empty() ? "nothing" : "'" + value + "'"; }

}  // namespace

std::string identityLine(const Identity& identity) {
    Json list = Json::array();
    for (const auto& [name, value] : identity) list.push_back({name, value});
    // Names of files need not be UTF-8.
    return list.dump(-1, ' ', true, Json::error_handler_t::replace);
}

Identity identityIn(const std::string& path, const std::string& kind) {
    const std::string header = stateHeader(path, kind);
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

void requireIdentity(const std::string& what, const Identity& file, const Identity& mine) {
    std::map<std::string, std::string> theirs(file.begin(), file.end());
    // As they come out of a file.
    const Json own = Json::parse(identityLine(mine));
    for (const Json& item : own) {
        const std::string name = item[0].get<std::string>(), value = item[1].get<std::string>();
        const auto found = theirs.find(name);
        const bool same = found != theirs.end() && found->second == value;
        if (same) {
            theirs.erase(found);
            continue;
        }
        if (name.starts_with(kIdentityFile)) {
            const std::string changed = name.substr(kIdentityFile.size());
            throw Error(found == theirs.end()
                            ? fmt::format("{}: it is of a scene that does not have the file '{}'", what, changed)
                            : fmt::format("{}: the scene's file '{}' has changed since", what, changed));
        }
        throw Error(fmt::format("{}: it was made with another {}: {}, here {}", what, name,
                                inQuotes(found == theirs.end() ? "" : found->second), inQuotes(value)));
    }
    if (theirs.empty()) return;
    const std::string& name = theirs.begin()->first;
    throw Error(name.starts_with(kIdentityFile) ? fmt::format("{}: it is of a scene that also has the file '{}'", what,
                                                              name.substr(kIdentityFile.size()))
                                                : fmt::format("{}: it was made with {} {}, here there is none", what,
                                                              name, inQuotes(theirs.begin()->second)));
}

Identity identityOfFiles(const Scene& scene, size_t from) {
    std::vector<uint64_t> hashes(scene.files.size());
    const fs::path folder = scene.files.empty() ? fs::path() : fs::path(scene.files[0]).parent_path();
    parallelFor(int(from), int(hashes.size()), 1, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) hashes[size_t(i)] = checksum(MappedFile(scene.files[size_t(i)]).bytes());
    });
    Identity identity;
    // A scene that has been moved to another folder, or another machine, is the same.
    for (size_t i = from; i < hashes.size(); ++i) {
        const fs::path path(scene.files[i]);
        const fs::path relative = path.lexically_relative(folder);
        identity.emplace_back(std::string(kIdentityFile) + (relative.empty() ? path : relative).string(),
                              fmt::format("{:016x}", hashes[i]));
    }
    return identity;
}

}  // namespace drc
