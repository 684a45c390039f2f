// Pairs of references of our own: rendered until their noise is small enough to measure with, and kept.
#pragma once
#include <string>

#include "base/parallel.h"

namespace drc {

struct ReferenceSettings {
    std::string program;              // drc
    std::string integrator = "path";  // or bdpt
    // The standard error that their noise may leave in the cross error of a perfect picture. The default is a fiftieth
    // of an error of .001.
    double error = 2e-5;
    int maxSpp = 1 << 16;  // of each reference: where that is given up
    int threads = 0;
};

struct RenderedReferences {
    std::string first, second;  // EXR, independent of each other; empty if it was cancelled
    std::string origin;         // "path, 2 x 96 spp, noise 2.3e-02, standard error about 1.2e-05"
};

// `folder`/NAME-WIDTHxHEIGHT-1.exr and -2.exr, if they are there, are of the same `key` and good enough; else they are
// rendered, with more and more samples. Each is the mean of two halves, so there are four streams of samples, all of
// different seeds, kept in `folder`/NAME-WIDTHxHEIGHT: after an interruption, or asked for a smaller error, it goes on.
// The halves tell the error: half of their difference is noise like that of their mean, so that the product of these
// differences is what the noise of both references puts into a cross error, and has the mean zero. Throws Error if the
// program fails.
RenderedReferences renderReferences(const std::string& scene, const std::string& name, int width, int height,
                                    const std::string& folder, const std::string& key,
                                    const ReferenceSettings& settings, const CancelToken* cancel);

}  // namespace drc
