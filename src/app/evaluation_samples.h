// The part of an evaluation's page that shows maps: the captured map, the result of each method, and its difference
// from the target.
#pragma once
#include <cstdint>
#include <string>

#include "app/evaluation.h"

namespace drc {

// One block for each example, with its first input, as HTML for htmlPage. Throws Error as ExampleSource::load does.
std::string sampleMaps(const EvaluatedGroup& group, const std::vector<size_t>& chosen);

}  // namespace drc
