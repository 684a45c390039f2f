// Identifies what a file was made of: pairs of a name, for messages, and a value. Files of states and of cells carry it
// in their first line.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace drc {

using Identity = std::vector<std::pair<std::string, std::string>>;
// Prefix of the names of files in an identity.
inline constexpr std::string_view kIdentityFile = "file ";

// As JSON in one line.
std::string identityLine(const Identity& identity);
// The identity in the first line of a file of this kind (StateWriter). Throws Error if the file cannot be read, is of
// another kind, or its first line is damaged.
Identity identityIn(const std::string& path, const std::string& kind);
// Throws Error, in one line that begins with `what`, if the identity of a file differs from `mine`, and says in which.
void requireIdentity(const std::string& what, const Identity& file, const Identity& mine);

// The contents of files of a scene from the given one on, by their paths relative to the scene's own. Throws Error if a
// file cannot be read.
Identity identityOfFiles(const Scene& scene, size_t from = 0);

}  // namespace drc
