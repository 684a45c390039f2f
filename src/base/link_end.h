// Where symbolic links end.
#pragma once
#include <string>
#include <system_error>

namespace drc {

// The file that is replaced or created by whoever writes to `path`: the end of its symbolic links, which need not
// exist. `path` itself if it is no link. Links to what is not a regular file, such as pipes in /proc, are not followed:
// they may have no path. failure: set if the links have no end.
std::string endOfLinks(const std::string& path, std::error_code& failure);

}  // namespace drc
