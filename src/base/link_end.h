// Where symbolic links end.
#pragma once
#include <string>
#include <system_error>

namespace drc {

// The file that writing to `path` replaces or creates: the end of its symbolic links, which need not exist; `path`
// itself if it is not a link. Links to anything but regular files, such as pipes in /proc, are not followed, because
// their target may have no path. failure: set if following fails, for instance for a cycle.
std::string endOfLinks(const std::string& path, std::error_code& failure);

}  // namespace drc
