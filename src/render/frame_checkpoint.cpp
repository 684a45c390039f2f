#include "render/frame_checkpoint.h"

#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>

#include "base/checksum.h"
#include "base/mapped_file.h"

namespace drc {
namespace {

constexpr const char *kFrame = "frame", *kLoaded = "frame of its scene";

}  // namespace

Identity frameIdentity(const FramePosition& position, const std::string& file) {
    Identity identity{{kFrame, std::to_string(position.frame)}, {kLoaded, std::to_string(position.loaded)}};
    // The scene's own list of files lacks the file that moved the camera.
    if (position.frame > position.loaded)
        identity.emplace_back(fmt::format("{}{} (frame {})", kIdentityFile,
                                          std::filesystem::path(file).filename().string(), position.frame),
                              fmt::format("{:016x}", checksum(MappedFile(file).bytes())));
    return identity;
}

std::optional<FramePosition> framePositionIn(const std::string& path) {
    FramePosition position{0, 0};
    for (const auto& [name, value] : Checkpoint::identityOf(path)) {
        if (name == kFrame) position.frame = std::atoi(value.c_str());
        if (name == kLoaded) position.loaded = std::atoi(value.c_str());
    }
    if (position.frame < 1 || position.loaded < 1 || position.loaded > position.frame) return {};
    return position;
}

}  // namespace drc
