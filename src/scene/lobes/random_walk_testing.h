// A random walk of light between a dielectric interface and a base, as pbrt-v4 evaluates layered materials; for tests.
#pragma once
#include "scene/lobes/bsdf.h"
#include "scene/lobes/lobe_testing.h"

namespace drc::test {

// Estimates the albedo of the stack towards wo. Both faces are lobes with the shading frame; between them light is
// absorbed and scattered isotropically with the given optical depth and albedo. Single scattering off a rough interface
// loses energy, as in pbrt; Face::Lossless samples again to compensate for it.
enum class Face { AsIs, Lossless };
template <typename Base>
double walkedAlbedo(const Bsdf& face, const Base& base, const Vec3& wo, float depth, float albedo, int walks,
                    Face kind = Face::AsIs) {
    std::mt19937 rng(21);
    double sum = 0;
    for (int walk = 0; walk < walks; ++walk) {
        double weight = 1;
        const auto through = [&](const Vec3& w) {
            for (int attempt = 0; attempt < (kind == Face::Lossless ? 50 : 1); ++attempt) {
                const float uLobe = uniform(rng);
                const auto s = face.sample(w, uLobe, uniform2(rng), LobeFlags::All, TransportMode::Importance);
                if (!s) continue;
                const double kept = s->f.x * std::abs(s->wi.z) / s->pdf;
                // Compensates for the energy lost by masking and by choosing the wrong lobe.
                if (kind == Face::AsIs)
                    weight *= kept;
                else if (uniform(rng) * 1.5 > kept)
                    continue;
                return s->wi;
            }
            return Vec3(0, 0, 0);
        };
        Vec3 d = through(wo);  // direction in which the light travels on; upwards once it has left the coat
        float z = 0;           // depth below the interface
        for (int i = 0; i < 200 && lengthSquared(d) > 0 && d.z < 0; ++i) {
            // Down to the base, reflected, and up to the interface, with scattering on the way.
            while (lengthSquared(d) > 0) {
                const float flight = -std::log(1 - uniform(rng));
                const float toEnd = (d.z < 0 ? depth - z : z) / std::abs(d.z);
                if (depth > 0 && flight < toEnd) {
                    z -= flight * d.z;
                    weight *= albedo;
                    d = randomDirection(rng);
                    if (weight == 0) d = Vec3(0, 0, 0);
                    continue;
                }
                if (d.z > 0) break;
                z = depth;
                const LobeSample s = base.sample(-d, uniform(rng), uniform2(rng), TransportMode::Importance);
                weight *= s.pdf > 0 ? s.f.x * absCosTheta(s.wi) / s.pdf : 0;
                d = s.pdf > 0 ? s.wi : Vec3(0, 0, 0);
            }
            z = 0;
            if (lengthSquared(d) == 0) break;
            d = through(-d);
        }
        if (d.z > 0) sum += weight;
    }
    return sum / walks;
}

}  // namespace drc::test
