// Pairs of references that we render ourselves, until their noise is small enough to measure with, and keep.
#pragma once
#include <string>

#include "base/parallel.h"

namespace drc {

struct ReferenceSettings {
    std::string program;              // drc
    std::string integrator = "path";  // or bdpt
    // The standard error that the references' noise may leave in the cross error of a perfect picture. The default is a
    // fiftieth of an error of .001.
    double error = 2e-5;
    int maxSpp = 1 << 16;  // samples a pixel of each reference at which rendering stops, whatever its noise
    int threads = 0;
};

struct RenderedReferences {
    std::string first, second;  // EXR, independent of each other; empty if cancelled
    std::string origin;         // "path, 2 x 96 spp, noise 2.3e-02, standard error about 1.2e-05"
};

// Returns `folder`/NAME-WIDTHxHEIGHT-1.exr and -2.exr if they exist, have the same `key` and are good enough; otherwise
// they are rendered, with more and more samples. Each is the mean of two halves, so there are four streams of samples
// with different seeds, kept in `folder`/NAME-WIDTHxHEIGHT: after an interruption, or for a smaller error, rendering
// continues there. The halves give the error: half of their difference has the noise of their mean, so the product of
// the two references' half differences is what their noise adds to a cross error, and has mean zero. Throws Error if
// the program fails.
RenderedReferences renderReferences(const std::string& scene, const std::string& name, int width, int height,
                                    const std::string& folder, const std::string& key,
                                    const ReferenceSettings& settings, const CancelToken* cancel);

}  // namespace drc
