// The pictures of a comparison, each once on the page: as figures, a strip a scene, and the rest in a gallery.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// Where a script finds a picture: figure[data-scene][data-method][data-budget], places in the report's lists;
// data-method="reference" has no budget. In the figure an img, then a dl of what was measured of it.
struct PagePictures {
    std::string figures;  // per scene the reference and all methods at the largest budget they have in common
    std::string gallery;  // all that the figures do not show
    bool empty() const { return figures.empty() && gallery.empty(); }
};

// Of the first repeat that worked. The budget of a scene's figures is that at which most methods have a picture, of
// these the largest; seconds come before samples and tasks. Throws Error, naming the file, on a picture that cannot be
// read or is not of the reference's size.
PagePictures pagePictures(const BenchReport& report, const std::string& folder);

}  // namespace drc
