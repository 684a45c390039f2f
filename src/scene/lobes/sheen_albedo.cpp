#include "scene/lobes/sheen_albedo.h"

namespace drc {

CosineCurve sheenAlbedo(float roughness) {
    // A Gaussian in the cosine plus a constant. Their parameters are rational functions of the roughness r, fitted to
    // the paper's table.
    const float r = std::clamp(roughness, 0.01f, 1.f);
    const float width = r * (0.0206607f + 1.58491f * r) / (0.0379424f + r * (1.32227f + r));
    const float centre = r * (-0.193854f + r * (-1.14885f + r * (1.7932f - 0.95943f * r * r))) / (0.046391f + r);
    const float offset = r * (0.000654023f + r * (-0.0207818f + 0.119681f * r)) / (1.26264f + r * (-1.92021f + r));
    CosineCurve curve;
    for (int i = 0; i < CosineCurve::kNodes; ++i) {
        const float x = (CosineCurve::cosineOf(i) - centre) / width;
        const float gauss = std::exp(-0.5f * x * x) / (width * std::sqrt(2 * kPi));
        curve[i] = std::clamp(gauss + offset, 0.f, 1.f);
    }
    return curve;
}

}  // namespace drc
