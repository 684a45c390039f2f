// Writing to what cannot be replaced as a file is: pipes, terminals, devices, descriptors that the program was given.
// No call blocks for good once the program is interrupted (base/interrupt.h): whoever should read then has one more
// second.
#pragma once
#include <string>
#include <string_view>

namespace drc {

// The open descriptor of this process that a path names: /dev/stdout, /dev/fd/3, /proc/self/fd/3, without links on the
// way to the last name. -1 if it names none.
int ownDescriptor(const std::string& path);

// Opens a pipe, terminal or device for writing, or a copy of ownDescriptor(path). A pipe that nobody has opened for
// reading is waited for, as the shell's redirection does. Throws Error with the reason alone.
int openStream(const std::string& path);

// Writes all of it. Throws Error with the reason alone.
void writeStream(int descriptor, std::string_view data);

}  // namespace drc
