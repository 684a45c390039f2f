// The part of an evaluation's page that shows maps: what was captured, what each method made of it, how that differs
// from the target.
#pragma once
#include <cstdint>
#include <string>

#include "app/evaluation.h"

namespace drc {

// One block an example, as HTML for htmlPage, of the first input of each. Throws Error as ExampleSource::load does.
std::string sampleMaps(const EvaluatedGroup& group, const std::vector<size_t>& chosen);

}  // namespace drc
