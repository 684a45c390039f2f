// For tests: writes BSDF files.
#pragma once
#include <cstring>
#include <string>

#include "math/catmull_rom.h"
#include "scene/lobes/fourier_testing.h"

namespace drc::test {

// Appends the bytes of a number.
template <typename T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

// The file of a table, as the format is defined: header, cosines, cumulative integrals over the spline of the means,
// offsets and orders, coefficients.
inline std::string fourierFile(const FourierSeries& s) {
    const SplineNodes nodes(s.cosines);
    const int n = nodes.size();
    uint32_t mostOrders = 0;
    for (const uint32_t orders : s.orders) mostOrders = std::max(mostOrders, orders);
    std::string bytes("SCATFUN\x01", 8);
    for (const int32_t field : {1, n, int(s.coefficients.size()), int(mostOrders), s.channels, 1, 0, 0, 0})
        append(bytes, field);
    append(bytes, s.eta);
    for (int i = 0; i < 4; ++i) append(bytes, 0.f);
    for (const float mu : s.cosines) append(bytes, mu);
    for (int o = 0; o < n; ++o) {
        const auto mean = [&](int i) {
            const size_t pair = size_t(o * n + i);
            return s.orders[pair] > 0 ? s.coefficients[s.offsets[pair]] : 0.f;
        };
        double sum = 0;
        append(bytes, 0.f);
        for (int i = 1; i < n; ++i) {
            constexpr int kSteps = 16;
            const float width = nodes[i] - nodes[i - 1];
            for (int k = 0; k < kSteps && width > 0; ++k) {
                const SplineWeights w = nodes.at(nodes[i - 1] + width * (float(k) + 0.5f) / kSteps);
                for (int j = 0; j < 4; ++j)
                    if (w.weight[size_t(j)] != 0) sum += w.weight[size_t(j)] * mean(w.node(j)) * width / kSteps;
            }
            append(bytes, float(sum));
        }
    }
    for (size_t pair = 0; pair < s.orders.size(); ++pair) {
        append(bytes, int32_t(s.offsets[pair]));
        append(bytes, int32_t(s.orders[pair]));
    }
    for (const float a : s.coefficients) append(bytes, a);
    return bytes;
}

}  // namespace drc::test
