#include "image/entropy.h"

#include <array>
#include <cmath>

#include "base/error.h"
#include "image/color.h"

namespace drc {

double luminanceEntropy(const Image& linear) {
    if (linear.empty()) throw Error("a picture without pixels has no entropy");
    std::array<int64_t, 256> count{};
    for (int y = 0; y < linear.height(); ++y)
        for (int x = 0; x < linear.width(); ++x) ++count[toByte(srgbEncode(luminance(linear.rgb(x, y))))];
    double bits = 0;
    for (const int64_t n : count) {
        if (n == 0) continue;
        const double p = double(n) / double(linear.pixelCount());
        bits -= p * std::log2(p);
    }
    return bits;
}

}  // namespace drc
