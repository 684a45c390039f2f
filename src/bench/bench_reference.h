// References of our own: rendered until two halves of their samples agree, and kept.
#pragma once
#include <string>

#include "base/parallel.h"

namespace drc {

struct ReferenceSettings {
    std::string program;              // drc
    std::string integrator = "path";  // or bdpt
    double error = 5e-4;              // wanted: relMSE (image/relmse.h) against the limit
    int maxSpp = 1 << 16;             // where that is given up
    int threads = 0;
};

struct Reference {
    std::string path;    // EXR
    std::string origin;  // "path, 1984 spp, relMSE about 2.3e-04"
};

// `folder`/NAME-WIDTHxHEIGHT.exr, if it is there, is of the same `key` and good enough; else it is rendered, with more
// and more samples in parts of independent seeds. The parts are kept until it is done: after an interruption it goes
// on. The error is estimated from the difference of the even and the odd parts' means: both have half of the samples,
// so the mean of all has about a quarter of the relMSE between them. Throws Error if the program fails; Reference with
// an empty path if cancelled.
Reference renderReference(const std::string& scene, const std::string& name, int width, int height,
                          const std::string& folder, const std::string& key, const ReferenceSettings& settings,
                          const CancelToken* cancel);

}  // namespace drc
