// Tries whether a file can be written, before the work that makes its contents.
#pragma once
#include <string>

namespace drc {

// Throws Error, naming the path and the system's reason, if a file cannot be written there now: the folder is missing
// or read-only, the disk is full, the name is too long or that of a folder. A temporary file is made beside the path
// and removed; what is at the path stays as it is. Pipes, sockets and devices are not opened, because their other side
// would notice: of these, only the permission is looked at.
void probeWriting(const std::string& path);

}  // namespace drc
