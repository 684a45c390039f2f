// For tests: random walks of light in a scattering medium below a smooth dielectric boundary.
#pragma once
#include <array>
#include <optional>
#include <random>
#include <vector>

#include "scene/lobes/fresnel.h"
#include "scene/lobes/lobe_testing.h"

namespace drc::test {

// Albedos of single scattering that one walk serves all of.
inline constexpr std::array<float, 9> kWalkedAlbedos = {0.1f, 0.3f, 0.5f, 0.7f, 0.8f, 0.9f, 0.95f, 0.98f, 0.99f};

struct WalkedShare {
    float mean, error;
};
// Share of the light that has entered that leaves again. cosOutside: of the light outside; none: light from everywhere.
inline std::array<WalkedShare, kWalkedAlbedos.size()> walkedShares(float g, float eta, std::optional<float> cosOutside,
                                                                   int walks) {
    constexpr size_t kCount = kWalkedAlbedos.size();
    std::mt19937 rng(31);
    std::array<double, kCount> sum{}, squares{};
    for (int walk = 0; walk < walks; ++walk) {
        float cosine = cosOutside.value_or(0);
        while (!cosOutside) {
            cosine = std::sqrt(uniform(rng));
            if (uniform(rng) >= fresnelDielectric(cosine, 1, eta)) break;
        }
        double mu = std::sqrt(1 - (1 - sqr(cosine)) / sqr(eta)), depth = 0;  // mu: downwards
        std::array<double, kCount> weight, left{};
        weight.fill(1);
        while (weight.back() > 0) {
            depth -= mu * std::log(1 - double(uniform(rng)));
            if (depth < 0) {
                const double inside = fresnelDielectric(float(-mu), eta, 1);
                for (size_t k = 0; k < kCount; ++k) {
                    left[k] += weight[k] * (1 - inside);
                    weight[k] *= inside;
                }
                mu = -mu;
                depth = 0;
            } else {
                for (size_t k = 0; k < kCount; ++k) weight[k] *= kWalkedAlbedos[k];
                // The cosine of the Henyey-Greenstein phase function, by inversion.
                const double u = uniform(rng), q = (1 - g * g) / (1 - g + 2 * g * u);
                const double cosTheta = std::abs(g) < 1e-3 ? 1 - 2 * u : (1 + g * g - q * q) / (2 * g);
                const double across = std::sqrt(std::max(0.0, (1 - cosTheta * cosTheta) * (1 - mu * mu)));
                mu = mu * cosTheta + across * std::cos(2 * std::numbers::pi * uniform(rng));
            }
            if (weight.back() < 1e-3) {
                const bool survives = uniform(rng) < 0.5f;
                for (double& w : weight) w = survives ? 2 * w : 0;
            }
        }
        for (size_t k = 0; k < kCount; ++k) {
            sum[k] += left[k];
            squares[k] += left[k] * left[k];
        }
    }
    std::array<WalkedShare, kCount> shares;
    for (size_t k = 0; k < kCount; ++k) {
        const double mean = sum[k] / walks;
        shares[k] = {float(mean), float(std::sqrt(std::max(0.0, squares[k] / walks - mean * mean) / walks))};
    }
    return shares;
}

}  // namespace drc::test
