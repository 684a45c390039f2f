#include "pbrt/glass_spectra.h"

#include <cmath>

#include "pbrt/cie.h"

namespace drc::pbrt {
namespace {

// Sellmeier's formula: n^2 = 1 + sum over i of b[i] l^2 / (l^2 - c[i]), l in micrometres. From Schott's catalogue,
// through the database of refractiveindex.info, which is in the public domain. pbrt's F5, F10 and F11 are SF5, SF10 and
// SF11.
struct Glass {
    std::string_view name;
    double b[3], c[3];
};
constexpr Glass kGlasses[] = {
    {"BK7", {1.03961212, 0.231792344, 1.01046945}, {0.00600069867, 0.0200179144, 103.560653}},
    {"BAF10", {1.5851495, 0.143559385, 1.08521269}, {0.00926681282, 0.0424489805, 105.613573}},
    {"FK51A", {0.971247817, 0.216901417, 0.904651666}, {0.00472301995, 0.0153575612, 168.68133}},
    {"LASF9", {2.00029547, 0.298926886, 1.80691843}, {0.0121426017, 0.0538736236, 156.530829}},
    {"SF5", {1.46141885, 0.247713019, 0.949995832}, {0.0111826126, 0.0508594669, 112.041888}},
    {"SF10", {1.62153902, 0.256287842, 1.64447552}, {0.0122241457, 0.0595736775, 147.468793}},
    {"SF11", {1.73759695, 0.313747346, 1.89878101}, {0.013188707, 0.0623068142, 155.23629}},
};

}  // namespace

std::optional<std::vector<SpectrumSample>> glassSpectrum(std::string_view name) {
    constexpr std::string_view kPrefix = "glass-";
    if (!name.starts_with(kPrefix)) return std::nullopt;
    name.remove_prefix(kPrefix.size());
    for (const Glass& glass : kGlasses) {
        const bool isFlint = glass.name.starts_with("SF");
        if (name != glass.name && !(isFlint && name == glass.name.substr(1))) continue;
        std::vector<SpectrumSample> samples;
        for (int nm = kCieFirst; nm <= kCieLast; nm += kCieStep) {
            const double l2 = double(nm) * nm * 1e-6;
            double n2 = 1;
            for (int i = 0; i < 3; ++i) n2 += glass.b[i] * l2 / (l2 - glass.c[i]);
            samples.push_back({float(nm), float(std::sqrt(n2))});
        }
        return samples;
    }
    return std::nullopt;
}

}  // namespace drc::pbrt
