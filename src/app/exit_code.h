// The code that the program ends with.
#pragma once

namespace drc {

// What main ends with if a command throws nothing; 0 at first. For a command that has done what it could, and said what
// is wrong, but is no success.
int& exitCode();

}  // namespace drc
