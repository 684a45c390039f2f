// Summary statistics of a picture's channels.
#pragma once
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace drc {

struct ChannelStatistics {
    // Taken over the finite values; zero if there are none.
    float min = 0, max = 0;
    double mean = 0;
    int64_t nan = 0, infinite = 0;
};

// One for each channel.
std::vector<ChannelStatistics> channelStatistics(const Image& image);

}  // namespace drc
