// Writes to files that cannot be replaced: pipes, terminals, devices, and descriptors that the program was given. Once
// the program is interrupted (base/interrupt.h), no call blocks for more than a second: so long a reader may take.
#pragma once
#include <string>
#include <string_view>

namespace drc {

// The open descriptor of this process that a path names: /dev/stdout, /dev/fd/3, /proc/self/fd/3, without links before
// the last name. -1 if the path names none.
int ownDescriptor(const std::string& path);

// Opens a pipe, terminal or device for writing, or a copy of ownDescriptor(path). Waits until a reader opens the pipe,
// as the shell's redirection does. Throws Error with the reason alone.
int openStream(const std::string& path);

// Writes all data. Throws Error with the reason alone.
void writeStream(int descriptor, std::string_view data);

}  // namespace drc
