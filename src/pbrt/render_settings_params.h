// What the film, the samplers and the integrators of both dialects read in the same way.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/param_set.h"
#include "scene/scene.h"

namespace drc::pbrt {

// Throw Error for a value that is not positive, or above most.
int positiveOf(const ParamSet& params, std::string_view name, int fallback, int most);
// Throws Error at pos unless the name is one of those known.
void checkKnown(const std::vector<std::string_view>& known, const std::string& kind, const std::string& name,
                const SourcePos& pos);

// Resolution, crop window, size and file of the film.
void applyFrame(const ParamSet& params, RenderSettings& settings);
void applyPixelBounds(const ParamSet& params, RenderSettings& settings);
// Samples a pixel of the sampler "stratified".
int samplesOfStratified(const ParamSet& params);
int maxDepthOf(const ParamSet& params);

// How lights are to be chosen: one of those known, and not needed. Throws Error for another.
void acceptChoiceOfLights(const ParamSet& params, std::string_view name, const std::vector<std::string_view>& known,
                          const std::string& integrator);

// Knobs of integrators, by the integrator's type, that are for its own algorithm: nothing here has use for them.
using IntegratorKnobs = std::map<std::string_view, std::vector<std::string_view>>;
// Accepts those of this type, and warns of what is then left. Of an integrator that is not there nothing is known:
// accepts whatever it has.
void acceptKnobs(const IntegratorKnobs& all, const std::string& type, const ParamSet& params);

}  // namespace drc::pbrt
