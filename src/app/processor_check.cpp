// On a processor that lacks the instructions that all other files are compiled for, ends the program with one line,
// before the first of their static initializers runs: otherwise it would end with SIGILL and no message. This file is
// compiled for any x86-64 processor (CMakeLists.txt), so it includes nothing with inline functions.
#include <unistd.h>

namespace {

// Tests for the level x86-64-v3; processors with these instructions also have lzcnt and movbe.
bool hasInstructions() {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
           __builtin_cpu_supports("fma");
}

// The smallest priority that programs may use: before all initializers without one.
__attribute__((constructor(101))) void checkProcessor() {
    if (hasInstructions()) return;
    static const char kMessage[] =
        "drc: error: this processor lacks AVX2, FMA or BMI2; drc needs x86-64-v3, which Intel's processors have since "
        "2013 (Haswell) and AMD's since 2015 (Excavator)\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMessage, sizeof kMessage - 1);
    _exit(1);
}

}  // namespace
