#include "pbrt/material_common.h"

#include "pbrt/suggest.h"

namespace drc::pbrt {

HairParams hairOf(const TextureParams& p, RgbTexturePtr reflectance, std::string_view colorName, FloatTexturePtr bump) {
    HairParams hair{.sigmaA = p.colorOrNull("sigma_a"),
                    .color = std::move(reflectance),
                    .eumelanin = p.scalarOrNull("eumelanin"),
                    .pheomelanin = p.scalarOrNull("pheomelanin"),
                    .eta = p.scalarOrNull("eta"),
                    .betaM = p.scalarOrNull("beta_m"),
                    .betaN = p.scalarOrNull("beta_n"),
                    .alpha = p.scalarOrNull("alpha"),
                    .bump = std::move(bump)};
    const std::string_view counts = hair.sigmaA ? "sigma_a" : colorName;
    const auto ignored = [&](bool given, std::string_view name) {
        if (given)
            warn(p.own().pos(), "parameter '" + std::string(name) + "' of " + p.own().owner() + " is ignored, as '" +
                                    std::string(counts) + "' is given");
    };
    if (hair.sigmaA) ignored(hair.color != nullptr, colorName);
    if (hair.sigmaA || hair.color) {
        ignored(hair.eumelanin != nullptr, "eumelanin");
        ignored(hair.pheomelanin != nullptr, "pheomelanin");
    }
    return hair;
}

MaterialPtr namedPart(const MaterialContext& c, const std::string& name, const std::string& what,
                      const SourcePos& pos) {
    const auto found = c.materials.find(name);
    if (!found)
        fail(pos, "the mix material's " + what + " '" + name + "' has not been defined" +
                      suggestion(name, c.materials.names()));
    if (!found->material) fail(pos, "the mix material's " + what + " '" + name + "' is 'none'");
    return found->material;
}

}  // namespace drc::pbrt
