#include "pbrt/named_spectra.h"

#include "pbrt/glass_spectra.h"
#include "pbrt/metal_spectra.h"

namespace drc::pbrt {

std::optional<std::vector<SpectrumSample>> namedIndex(const std::string& name, bool& isStandIn) {
    isStandIn = false;
    if (auto glass = glassSpectrum(name)) return glass;
    if (!name.starts_with("metal-")) return std::nullopt;
    if (auto metal = metalSpectrum(name)) return metal;
    for (const std::string part : {"eta", "k"}) {
        if (name == "metal-CuZn-" + part) {
            isStandIn = true;
            return metalSpectrum("metal-Cu-" + part);
        }
        // Oxides without absorption: their indices at the sodium line. R. E. Stephens and I. H. Malitson (1952); J. R.
        // DeVore (1951), the ordinary ray of rutile.
        if (name == "metal-MgO-" + part) return {{{589.3f, part == "k" ? 0 : 1.7375f}}};
        if (name == "metal-TiO2-" + part) return {{{589.3f, part == "k" ? 0 : 2.6131f}}};
    }
    return std::nullopt;
}

}  // namespace drc::pbrt
