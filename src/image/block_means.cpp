#include "image/block_means.h"

#include <algorithm>
#include <array>

#include "base/error.h"

namespace drc {

Image blockMeans(const Image& image, int size) {
    if (size < 1) throw Error("the size of a block of pixels must be positive, not " + std::to_string(size));
    Image means((image.width() + size - 1) / size, (image.height() + size - 1) / size);
    for (int by = 0; by < means.height(); ++by)
        for (int bx = 0; bx < means.width(); ++bx) {
            std::array<double, 3> sum{};
            int count = 0;
            for (int y = by * size; y < std::min((by + 1) * size, image.height()); ++y)
                for (int x = bx * size; x < std::min((bx + 1) * size, image.width()); ++x) {
                    const Rgb color = image.rgb(x, y);
                    if (!isFinite(color)) continue;
                    for (int c = 0; c < 3; ++c) sum[size_t(c)] += color[c];
                    ++count;
                }
            for (int c = 0; c < 3; ++c) means.at(bx, by, c) = float(sum[size_t(c)] / count);  // 0 / 0 is NaN
        }
    return means;
}

}  // namespace drc
