#include "app/models.h"

#include <cstdlib>
#include <filesystem>

#include "base/error.h"

namespace drc {
namespace {

constexpr const char* kDefaultModel = "drc.safetensors";

}  // namespace

std::string findWeights(const std::string& weights) {
    namespace fs = std::filesystem;
    if (!weights.empty()) return weights;
    if (const char* named = std::getenv("DRC_WEIGHTS")) return named;
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    std::string tried;
    for (const fs::path& directory :
         {program / "models", program / "../../models", program / "../share/drc/models", fs::path("models")}) {
        const fs::path candidate = (directory / kDefaultModel).lexically_normal();
        if (fs::exists(candidate, ignored)) return candidate.string();
        tried += "\n  " + candidate.string();
    }
    throw Error(
        "the network's weights were not found; name them with --weights, or render with --enhancer gaussian. Tried:" +
        tried);
}

}  // namespace drc
