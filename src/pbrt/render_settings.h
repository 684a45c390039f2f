// Film, Sampler and Integrator: what a file says of the picture, not of the scene.
#pragma once
#include <string>

#include "pbrt/param_set.h"
#include "scene/scene.h"

namespace drc::pbrt {

// Each sets its part of the settings. Throws Error for wrong parameters; film and sampler also for unknown types. An
// integrator may have any name: which of them exist is for the renderer to say.
void applyFilm(const std::string& type, const ParamSet& params, RenderSettings& settings);
void applySampler(const std::string& type, const ParamSet& params, RenderSettings& settings);
void applyIntegrator(const std::string& type, const ParamSet& params, RenderSettings& settings);
// Accepted and without effect: there is one accelerator.
void checkAccelerator(const std::string& type, const ParamSet& params);

}  // namespace drc::pbrt
