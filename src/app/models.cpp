#include "app/models.h"

#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "app/shipped_folders.h"
#include "base/error.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".safetensors";

// The names of the shipped networks, in order, separated by commas.
std::string shippedNetworks() {
    std::set<std::string> names;
    std::error_code ignored;
    for (const fs::path& folder : shippedFolders("models"))
        for (const auto& entry : fs::directory_iterator(folder, ignored))
            if (entry.path().extension() == kExtension) names.insert(entry.path().stem().string());
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

std::string findShipped(const std::string& name, std::string& tried) {
    std::error_code ignored;
    for (const fs::path& folder : shippedFolders("models")) {
        const fs::path candidate = folder / (name + kExtension);
        if (fs::exists(candidate, ignored)) return candidate.string();
        tried += "\n  " + candidate.string();
    }
    return "";
}

}  // namespace

std::string findWeights(const std::string& weights) {
    const char* fromEnvironment = std::getenv("DRC_WEIGHTS");
    const std::string wanted = weights.empty() && fromEnvironment ? fromEnvironment : weights;
    std::string tried;
    if (wanted.empty()) {
        const std::string found = findShipped(kDefaultNetwork, tried);
        if (!found.empty()) return found;
        throw Error(
            "the network's weights were not found; name them with --weights, or render with --map-denoiser gaussian. "
            "Tried:" +
            tried);
    }
    if (fs::path(wanted).filename() != wanted || fs::path(wanted).extension() == kExtension) return wanted;
    // The name comes first, because the program itself may lie in the current folder and has the name of a network.
    const std::string found = findShipped(wanted, tried);
    if (!found.empty()) return found;
    std::error_code ignored;
    if (fs::exists(wanted, ignored)) return wanted;
    throw Error(fmt::format("{} {}: neither a file nor a network that comes with the program ({})",
                            weights.empty() ? "DRC_WEIGHTS" : "--weights", wanted, shippedNetworks()));
}

}  // namespace drc
