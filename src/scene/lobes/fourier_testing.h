// For tests: tables of BSDFs by the definition of their format, the Fourier transform of f |cos| in the azimuth.
#pragma once
#include <numbers>

#include "scene/lobes/fourier_table.h"
#include "scene/lobes/local_directions.h"

namespace drc::test {

// So many cosines for each side of the surface, denser towards both ends of each, with 0 twice.
inline std::vector<float> fourierCosines(int perSide) {
    std::vector<float> side;
    for (int i = 0; i < perSide; ++i) side.push_back(float(0.5 - 0.5 * std::cos(std::numbers::pi * i / (perSide - 1))));
    std::vector<float> all;
    for (int i = perSide - 1; i >= 0; --i) all.push_back(-side[size_t(i)]);
    all.front() = -1;
    all.insert(all.end(), side.begin(), side.end());
    all.back() = 1;
    return all;
}

// f(wo, wi): BSDF of an isotropic surface, in importance mode. Coefficients of less than `least` of a series' sum are
// left out at its end.
template <typename F>
FourierSeries fourierSeriesOf(const F& f, const std::vector<float>& cosines, int channels = 1, float eta = 1,
                              int mostOrders = 64, double least = 1e-5) {
    FourierSeries s{
        .cosines = cosines, .offsets = {}, .orders = {}, .coefficients = {}, .channels = channels, .eta = eta};
    // f is even in the azimuth, so that half of the circle is enough.
    const int n = int(cosines.size()), steps = 2 * mostOrders;
    const auto azimuthOf = [&](int k) { return std::numbers::pi * (k + 0.5) / steps; };
    std::vector<double> waves;  // [order * steps + k]
    for (int order = 0; order < mostOrders; ++order)
        for (int k = 0; k < steps; ++k) waves.push_back(std::cos(order * azimuthOf(k)));
    // Of directions in the surface itself, f is that of the side whose node it is.
    const auto inside = [&](int i) {
        const float mu = cosines[size_t(i)];
        if (mu != 0) return mu;
        return i + 1 < n && cosines[size_t(i + 1)] == 0 ? -1e-5f : 1e-5f;
    };
    std::array<std::vector<double>, 3> values;
    for (auto& v : values) v.resize(size_t(steps));
    for (int o = 0; o < n; ++o)
        for (int i = 0; i < n; ++i) {
            const float outgoing = inside(o), incident = inside(i);
            const float sinO = safeSqrt(1 - outgoing * outgoing), sinI = safeSqrt(1 - incident * incident);
            double largest = 0;
            for (int k = 0; k < steps; ++k) {
                const double azimuth = azimuthOf(k);
                const Vec3 wo(sinO, 0, outgoing);
                const Vec3 wi(-sinI * float(std::cos(azimuth)), -sinI * float(std::sin(azimuth)), -incident);
                const Rgb value = f(wo, wi) * std::abs(cosines[size_t(i)]);
                values[0][size_t(k)] = luminance(value);
                values[1][size_t(k)] = value.x;
                values[2][size_t(k)] = value.z;
                largest = std::max(largest, double(luminance(value)));
            }
            std::array<std::vector<double>, 3> a;
            int orders = 0;
            for (int c = 0; c < channels && largest > 0; ++c)
                for (int order = 0; order < mostOrders; ++order) {
                    double sum = 0;
                    for (int k = 0; k < steps; ++k)
                        sum += values[size_t(c)][size_t(k)] * waves[size_t(order * steps + k)];
                    a[size_t(c)].push_back(sum * (order == 0 ? 1 : 2) / steps);
                    if (std::abs(a[size_t(c)].back()) > least * largest) orders = std::max(orders, order + 1);
                }
            s.offsets.push_back(uint32_t(s.coefficients.size()));
            s.orders.push_back(uint32_t(orders));
            for (int c = 0; c < channels; ++c)
                for (int k = 0; k < orders; ++k) s.coefficients.push_back(float(a[size_t(c)][size_t(k)]));
        }
    return s;
}

// The same of a lobe of ours.
template <typename L>
FourierSeries fourierSeriesOfLobe(const L& lobe, const std::vector<float>& cosines, int channels = 1, float eta = 1,
                                  int mostOrders = 64) {
    const auto f = [&](const Vec3& wo, const Vec3& wi) {
        if constexpr (requires { lobe.f(wo, wi, TransportMode::Importance); })
            return lobe.f(wo, wi, TransportMode::Importance);
        else
            return sameHemisphere(wo, wi) ? lobe.f(wo, wi) : Rgb(0.f);
    };
    return fourierSeriesOf(f, cosines, channels, eta, mostOrders);
}

}  // namespace drc::test
