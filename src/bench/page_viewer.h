// The viewer of a comparison's page, for two pictures: a slider that wipes between them, a magnifier that follows the
// pointer, and their differences from the reference. It needs a script, which finds the pictures as page_pictures.h
// says, and stays hidden without it.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

std::string viewer(const BenchReport& report);
// The script belongs at the end of the page, after all pictures.
std::string viewerScript();
// CSS of the viewer and of page_pictures.h.
std::string pictureStyle();

}  // namespace drc
