// The code that the program ends with.
#pragma once

namespace drc {

// The exit code of main if a command throws nothing; 0 at first. A command sets it when it has done what it could and
// reported the fault, but did not succeed.
int& exitCode();

}  // namespace drc
