#include "reconstruct/oidn_library.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "base/error.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNames[] = {"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1", "libOpenImageDenoise.so"};

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

// The path of the library in a folder or in its subfolder lib, as in the archives that Intel publishes; empty if none.
fs::path inFolder(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::path& place : {folder, folder / "lib"})
        for (const char* name : kNames)
            if (fs::is_regular_file(place / name, ignored)) return place / name;
    return {};
}

std::string namedLibrary(const std::string& by, const std::string& value) {
    std::error_code ignored;
    if (fs::is_directory(value, ignored)) {
        const fs::path found = inFolder(value);
        if (found.empty()) throw Error(fmt::format("{}: there is no {} in this folder", by, kNames[0]));
        return fs::absolute(found).string();
    }
    // The loader takes a name for a path only if it contains a slash.
    if (fs::exists(value, ignored)) return fs::absolute(value).string();
    if (value.find('/') != std::string::npos) throw Error(fmt::format("{}: there is no such file or folder", by));
    return value;
}

// The subfolders of a folder whose names start with `begin`, in reverse alphabetical order. Which of Python 3.9 and
// 3.11 comes first does not matter.
std::vector<fs::path> subfolders(const fs::path& folder, const std::string& begin) {
    std::vector<fs::path> found;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().filename().string().starts_with(begin) && entry.is_directory(ignored))
            found.push_back(entry.path());
    std::sort(found.rbegin(), found.rend());
    return found;
}

// The prefixes of all Pythons: the packages of PREFIX/bin/python3 are in PREFIX/lib/python3.x/site-packages.
std::vector<fs::path> pythonPrefixes(const OidnSearch& search) {
    std::vector<fs::path> prefixes{search.virtualEnv};
    std::istringstream folders(search.path);
    for (std::string text; std::getline(folders, text, ':');) {
        const fs::path folder = text;
        std::error_code failed;
        if (!folder.is_absolute() || !fs::exists(folder / "python3", failed)) continue;
        prefixes.push_back((folder / "..").lexically_normal());
        // In a virtual environment, python3 is a link to the Python that the environment was made from.
        const fs::path real = fs::canonical(folder / "python3", failed);
        if (!failed) prefixes.push_back(real.parent_path().parent_path());
        // In pyenv, python3 is not a link but a script that chooses one of pyenv's versions when it is run.
        if (folder.filename() == "shims")
            for (const fs::path& version : subfolders(folder.parent_path() / "versions", ""))
                prefixes.push_back(version);
    }
    prefixes.insert(prefixes.end(), {search.home / ".local", search.root / "usr/local", search.root / "usr"});
    return prefixes;
}

}  // namespace

OidnSearch OidnSearch::ofProcess(const std::string& option) {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    return {option, variable("DRC_OIDN"), program, "/", variable("HOME"), variable("VIRTUAL_ENV"), variable("PATH")};
}

OidnLibraries findOidn(const OidnSearch& search) {
    OidnLibraries found;
    const bool byOption = !search.option.empty();
    if (byOption || !search.named.empty()) {
        const std::string& value = byOption ? search.option : search.named;
        found.namedBy = (byOption ? "--oidn-library " : "DRC_OIDN ") + value;
        found.candidates = {namedLibrary(found.namedBy, value)};
        return found;
    }
    const auto add = [&](const fs::path& library) {
        const std::string file = library.string();
        if (!file.empty() &&
            std::find(found.candidates.begin(), found.candidates.end(), file) == found.candidates.end())
            found.candidates.push_back(file);
    };
    add(inFolder(search.program / "oidn"));
    add(inFolder((search.program / "../lib/drc/oidn").lexically_normal()));
    for (const char* name : kNames) add(name);
    std::vector<fs::path> sites;
    for (const fs::path& prefix : pythonPrefixes(search)) {
        if (!prefix.is_absolute()) continue;
        for (const fs::path& python : subfolders(prefix / "lib", "python3"))
            for (const char* packages : {"site-packages", "dist-packages"}) sites.push_back(python / packages);
    }
    for (const char* package : {"pyoidn/oidn", "bpy"})
        for (const fs::path& site : sites) add(inFolder(site / package));
    return found;
}

}  // namespace drc
