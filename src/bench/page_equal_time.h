// The part of a comparison's page that gives every method the same seconds.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// Per budget in seconds a table: a block a scene, a row a method, and the geometric means over the scenes of the
// methods' errors, as multiples of the best path+oidn's, or of the first method's without one. Empty if nothing was run
// so.
std::string equalTimeTables(const BenchReport& report);

}  // namespace drc
