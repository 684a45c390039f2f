// The pictures of a comparison, each once on the page: as figures, one strip for each scene, and the rest in a gallery.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// A script finds a picture as figure[data-scene][data-method][data-budget], with indices in the report's lists;
// data-method="reference" has no budget. The figure contains an img, then a dl of the picture's measures.
struct PagePictures {
    std::string figures;  // for each scene the reference and all methods at their largest common budget
    std::string gallery;  // all pictures that the figures do not show
    bool empty() const { return figures.empty() && gallery.empty(); }
};

// Pictures are those of the first successful repeat. The budget of a scene's figures is the one at which most methods
// have a picture, and of these the largest; seconds come before samples and tasks. Throws Error, naming the file, if a
// picture cannot be read or has another size than the reference.
PagePictures pagePictures(const BenchReport& report, const std::string& folder);

}  // namespace drc
