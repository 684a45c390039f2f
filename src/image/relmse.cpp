#include "image/relmse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace drc {

RadianceErrors radianceErrors(const Image& reference, const Image& test) {
    requireSameSize(reference, test);
    RadianceErrors errors;
    std::vector<double> relative;
    relative.reserve(reference.pixelCount());
    std::array<double, 3> sumR{}, sumT{};
    double squares = 0, absolutes = 0;
    for (int y = 0; y < reference.height(); ++y) {
        for (int x = 0; x < reference.width(); ++x) {
            const Rgb r = reference.rgb(x, y), t = test.rgb(x, y);
            const bool finiteR = isFinite(r), finiteT = isFinite(t);
            errors.nonFiniteReference += !finiteR;
            errors.nonFiniteTest += !finiteT;
            if (!finiteR || !finiteT) continue;
            double pixel = 0;
            for (int c = 0; c < 3; ++c) {
                const double d = double(t[c]) - r[c];
                pixel += d * d / (double(r[c]) * r[c] + 0.01);
                squares += d * d;
                absolutes += std::abs(d);
                sumR[size_t(c)] += r[c];
                sumT[size_t(c)] += t[c];
            }
            relative.push_back(pixel / 3);
        }
    }
    if (relative.empty()) {
        errors.relmse = errors.mse = errors.l1 = std::numeric_limits<double>::quiet_NaN();
        errors.meanRatio.fill(errors.relmse);
        return errors;
    }
    const double values = 3 * double(relative.size());
    errors.mse = squares / values;
    errors.l1 = absolutes / values;
    for (size_t c = 0; c < 3; ++c) errors.meanRatio[c] = sumR[c] == sumT[c] ? 1 : sumT[c] / sumR[c];
    std::sort(relative.begin(), relative.end());
    const auto dropped = static_cast<std::ptrdiff_t>(std::floor(double(relative.size()) * kRelMseDropped));
    const auto kept = relative.end() - dropped;
    errors.relmse = std::accumulate(relative.begin(), kept, 0.0) / double(kept - relative.begin());
    return errors;
}

}  // namespace drc
