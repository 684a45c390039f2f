// Homogeneous participating media: fog, smoke, milk, tinted glass (PBR 3e, sections 11.1 and 11.3).
#pragma once
#include <cmath>

#include "math/vec.h"

namespace drc {

struct Medium {
    Rgb sigmaA{0.f};    // absorption coefficient, per unit of length in world space
    Rgb sigmaS{0.f};    // scattering coefficient, in the same unit
    Rgb emission{0.f};  // Le: the medium emits the radiance sigmaA * emission per unit of length
    float g = 0;        // mean cosine of the scattering angle, in (-1, 1)

    Rgb sigmaT() const { return sigmaA + sigmaS; }
    bool scatters() const { return !isBlack(sigmaS); }
    // Transmittance over a distance, which may be infinite.
    Rgb transmittance(float distance) const {
        const Rgb t = sigmaT();
        const auto through = [&](float sigma) { return sigma > 0 ? std::exp(-sigma * distance) : 1; };
        return {through(t.x), through(t.y), through(t.z)};
    }
    // Radiance that arrives at the start of a segment of this length from emission along the segment, attenuated by the
    // medium on the way.
    Rgb emitted(float distance) const;
    // Fraction of light that is scattered within a segment of this length: albedo * (1 - transmittance).
    Rgb scatteredIn(float distance) const { return albedo() * (Rgb(1.f) - transmittance(distance)); }
    // Single-scattering albedo; zero in channels where sigmaT is zero.
    Rgb albedo() const;
};

// The media on both sides of a surface; null: empty space.
struct MediumInterface {
    const Medium* inside = nullptr;
    const Medium* outside = nullptr;  // on the side of the geometric normal
    // Whether the surface separates two media. If not, the medium of the arriving ray is on both sides.
    bool changes() const { return inside != outside; }
    bool operator==(const MediumInterface&) const = default;
};

}  // namespace drc
