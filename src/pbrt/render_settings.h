// Film, Sampler and Integrator: the directives that describe the picture, not the scene.
#pragma once
#include <string>

#include "pbrt/param_set.h"
#include "scene/scene.h"

namespace drc::pbrt {

// Each function sets its part of the settings. Throws Error for wrong parameters; film and sampler also for unknown
// types. Integrators may have any name, because the renderer determines which exist.
void applyFilm(const std::string& type, const ParamSet& params, RenderSettings& settings);
void applySampler(const std::string& type, const ParamSet& params, RenderSettings& settings);
void applyIntegrator(const std::string& type, const ParamSet& params, RenderSettings& settings);
// Accepts any accelerator. It has no effect, because there is only one.
void checkAccelerator(const std::string& type, const ParamSet& params);

}  // namespace drc::pbrt
