// Tests whether a file can be written, before the work that produces its contents.
#pragma once
#include <string>

namespace drc {

// Throws Error, with the path and the system's reason, if a file cannot be written there now: the folder is missing or
// read-only, the disk is full, or the name is too long or names a folder. Makes a temporary file beside the path and
// removes it; an existing file stays unchanged. For pipes, sockets and devices, only the permission is checked, because
// opening them would be noticed by their other side.
void probeWriting(const std::string& path);

}  // namespace drc
