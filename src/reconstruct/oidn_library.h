// Finds the shared library of Open Image Denoise, which is loaded at run time: Debian does not package it, but Python
// packages carry it.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace drc {

// Inputs of the search, besides the files themselves.
struct OidnSearch {
    std::string option;             // of --oidn-library; empty: not given
    std::string named;              // the variable DRC_OIDN; empty: not set
    std::filesystem::path program;  // the folder of the running program
    std::filesystem::path root;     // of the file system, below which usr lies
    std::filesystem::path home, virtualEnv;
    std::string path;  // the variable PATH

    // Inputs taken from this process. option: the value of --oidn-library.
    static OidnSearch ofProcess(const std::string& option);
};

struct OidnLibraries {
    // Who names the library: "--oidn-library" or "DRC_OIDN" with its value; empty if nobody does.
    std::string namedBy;
    // Absolute paths of files that exist, and bare names, which the system's loader looks up; the best first. The first
    // that can be loaded is the one to take. If somebody names the library, there is no other.
    std::vector<std::string> candidates;
};

// A library that is named (by the option, else by the variable) may be a file, a folder that has it or whose lib has
// it, or a bare name. Otherwise it is looked for, in this order: in the folder oidn beside the program, which
// scripts/quickstart fills, and in ../lib/drc/oidn; by the system's loader; in the Python packages pyoidn, then bpy, of
// $VIRTUAL_ENV, of each python3 on PATH, of ~/.local, of /usr/local and of /usr. Python is not run for it. Throws Error
// if the library that is named does not exist.
OidnLibraries findOidn(const OidnSearch& search);

// Advice for installing the library, which ends the message that none was found.
inline constexpr const char* kHowToGetOidn =
    "scripts/quickstart fetches it, pip install pyoidn has it, $DRC_OIDN or --oidn-library name it";

}  // namespace drc
