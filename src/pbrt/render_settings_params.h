// Parameters of films, samplers and integrators with the same meaning in both dialects.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/param_set.h"
#include "scene/scene.h"

namespace drc::pbrt {

// The parameter's value. Throws Error unless it is from 1 to `most`.
int positiveOf(const ParamSet& params, std::string_view name, int fallback, int most);
// Throws Error at pos unless the name is in the list.
void checkKnown(const std::vector<std::string_view>& known, const std::string& kind, const std::string& name,
                const SourcePos& pos);

// Resolution, crop window, diagonal and file name of the film.
void applyFrame(const ParamSet& params, RenderSettings& settings);
void applyPixelBounds(const ParamSet& params, RenderSettings& settings);
// Samples per pixel of the sampler "stratified".
int samplesOfStratified(const ParamSet& params);
int maxDepthOf(const ParamSet& params);

// Accepts the strategy for choosing lights, which has no effect. Throws Error if the name is not in `known`.
void acceptChoiceOfLights(const ParamSet& params, std::string_view name, const std::vector<std::string_view>& known,
                          const std::string& integrator);

// For each type of integrator, the parameters that concern only its own algorithm and have no effect here.
using IntegratorKnobs = std::map<std::string_view, std::vector<std::string_view>>;
// Accepts the parameters listed for this type and warns of the remaining ones. For unknown integrators, accepts all.
void acceptKnobs(const IntegratorKnobs& all, const std::string& type, const ParamSet& params);

}  // namespace drc::pbrt
