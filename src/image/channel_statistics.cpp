#include "image/channel_statistics.h"

#include <algorithm>
#include <cmath>

namespace drc {

std::vector<ChannelStatistics> channelStatistics(const Image& image) {
    std::vector<ChannelStatistics> all(size_t(image.channels()));
    for (int c = 0; c < image.channels(); ++c) {
        ChannelStatistics& s = all[size_t(c)];
        int64_t finite = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const float v = image.at(x, y, c);
                if (std::isnan(v)) {
                    ++s.nan;
                } else if (std::isinf(v)) {
                    ++s.infinite;
                } else {
                    s.min = finite == 0 ? v : std::min(s.min, v);
                    s.max = finite == 0 ? v : std::max(s.max, v);
                    s.mean += double(v);
                    ++finite;
                }
            }
        if (finite > 0) s.mean /= double(finite);
    }
    return all;
}

}  // namespace drc
