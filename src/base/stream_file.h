// Writes to files that cannot be replaced: pipes, terminals, devices, and descriptors that the program was given. Once
// the program is interrupted (base/interrupt.h), calls fail if the reader takes longer than a second.
#pragma once
#include <string>
#include <string_view>

namespace drc {

// The number of this process's descriptor that a path names, such as /dev/fd/3 or /proc/self/fd/3; -1 if it names none.
// The last component must be the number itself: resolve links such as /dev/stdout first (link_end.h).
int ownDescriptor(const std::string& path);

// Opens a pipe, terminal or device for writing, or duplicates ownDescriptor(path). Waits until a reader opens the pipe,
// as the shell's redirection does. Throws Error with only the reason.
int openStream(const std::string& path);

// Writes all data. Throws Error with only the reason.
void writeStream(int descriptor, std::string_view data);

}  // namespace drc
