// What compares two pictures of a comparison's page: a slider that wipes between them, a magnified part that follows
// the pointer, and their differences to the reference. It needs a script, which finds the pictures as page_pictures.h
// says, and stays hidden without.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

std::string viewer(const BenchReport& report);
// For the end of the page, after all pictures.
std::string viewerScript();
// CSS of the viewer and of page_pictures.h.
std::string pictureStyle();

}  // namespace drc
