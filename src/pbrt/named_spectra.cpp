#include "pbrt/named_spectra.h"

#include <cmath>

#include "pbrt/cie.h"
#include "pbrt/glass_spectra.h"
#include "pbrt/metal_spectra.h"

namespace drc::pbrt {
namespace {

// Oxides that pbrt lists among its metals. They do not absorb. n^2 = a + b l^2 + c l^4 + d / (l^2 - e), l in
// micrometres. R. E. Stephens and I. H. Malitson, "Index of Refraction of Magnesium Oxide", J. Res. Natl. Bur. Stand.
// 49 (1952); J. R. DeVore, "Refractive Indices of Rutile and Sphalerite", J. Opt. Soc. Am. 41 (1951), the ordinary ray.
// Through the database of refractiveindex.info, which is in the public domain.
struct Oxide {
    const char* name;
    double a, b, c, d, e;
};
constexpr Oxide kOxides[] = {{"MgO", 2.956362, -0.01062387, -0.0000204968, 0.02195770, 0.01428322},
                             {"TiO2", 5.913, 0, 0, 0.2441, 0.0803}};

std::vector<SpectrumSample> indexOf(const Oxide& oxide) {
    std::vector<SpectrumSample> samples;
    for (int nm = kCieFirst; nm <= kCieLast; nm += kCieStep) {
        const double l2 = double(nm) * nm * 1e-6;
        samples.push_back(
            {float(nm), float(std::sqrt(oxide.a + oxide.b * l2 + oxide.c * l2 * l2 + oxide.d / (l2 - oxide.e)))});
    }
    return samples;
}

}  // namespace

std::optional<std::vector<SpectrumSample>> namedIndex(const std::string& name) {
    if (auto glass = glassSpectrum(name)) return glass;
    if (!name.starts_with("metal-")) return std::nullopt;
    for (const Oxide& oxide : kOxides) {
        if (name == std::string("metal-") + oxide.name + "-eta") return indexOf(oxide);
        if (name == std::string("metal-") + oxide.name + "-k") return {{{float(kCieFirst), 0}}};
    }
    return metalSpectrum(name);
}

}  // namespace drc::pbrt
