// Film, Sampler and Integrator of pbrt-v4; the counterpart of render_settings.h.
#pragma once
#include <string>

#include "pbrt/param_set.h"
#include "scene/scene.h"

namespace drc::pbrt {

void applyFilmV4(const std::string& type, const ParamSet& params, RenderSettings& settings);
void applySamplerV4(const std::string& type, const ParamSet& params, RenderSettings& settings);
void applyIntegratorV4(const std::string& type, const ParamSet& params, RenderSettings& settings);

}  // namespace drc::pbrt
