// Finds the shared library of Open Image Denoise, which is loaded at run time: Debian does not package it, but Python
// packages carry it.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace drc {

// Inputs of the search, besides the file system.
struct OidnSearch {
    std::string option;             // value of --oidn-library; empty: not given
    std::string named;              // value of DRC_OIDN; empty: not set
    std::filesystem::path program;  // the folder of the running program
    std::filesystem::path root;     // root of the file system, where usr is
    std::filesystem::path home, virtualEnv;
    std::string path;  // value of PATH

    // Inputs taken from this process. option: the value of --oidn-library.
    static OidnSearch ofProcess(const std::string& option);
};

struct OidnLibraries {
    // The option or variable that names the library, "--oidn-library" or "DRC_OIDN", with its value; empty if neither
    // does.
    std::string namedBy;
    // Absolute paths of files that exist, and bare names for the system's loader, the best first; the first that can be
    // loaded should be used. A library that is named is the only candidate.
    std::vector<std::string> candidates;
};

// A library that is named (by the option, else by the variable) may be a file, a folder that contains it directly or in
// lib, or a bare name. Otherwise it is searched for, in this order: in the folder oidn beside the program, which
// scripts/quickstart fills, and in ../lib/drc/oidn; by the system's loader; in the Python packages pyoidn, then bpy, of
// $VIRTUAL_ENV, of each python3 on PATH, of ~/.local, of /usr/local and of /usr. Python itself is not run. Throws Error
// if a library that is named does not exist.
OidnLibraries findOidn(const OidnSearch& search);

// Advice for installing the library, which ends the message that none was found.
inline constexpr const char* kHowToGetOidn =
    "scripts/quickstart fetches it, pip install pyoidn has it, $DRC_OIDN or --oidn-library name it";

}  // namespace drc
