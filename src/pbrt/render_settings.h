// Film, Sampler and Integrator: the directives about the picture rather than the scene.
#pragma once
#include <string>

#include "pbrt/param_set.h"
#include "scene/scene.h"

namespace drc::pbrt {

// Each sets its part of the settings. Throws Error for wrong parameters; film and sampler also for unknown types.
// Integrators may have any name, since the renderer decides which exist.
void applyFilm(const std::string& type, const ParamSet& params, RenderSettings& settings);
void applySampler(const std::string& type, const ParamSet& params, RenderSettings& settings);
void applyIntegrator(const std::string& type, const ParamSet& params, RenderSettings& settings);
// Accepts accelerators, which have no effect, since there is only one.
void checkAccelerator(const std::string& type, const ParamSet& params);

}  // namespace drc::pbrt
