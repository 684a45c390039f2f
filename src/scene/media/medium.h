// Homogeneous participating media: fog, smoke, milk, tinted glass (PBR 3e, sections 11.1 and 11.3).
#pragma once
#include <cmath>

#include "math/vec.h"

namespace drc {

struct Medium {
    Rgb sigmaA{0.f};    // what a unit of length in world space absorbs
    Rgb sigmaS{0.f};    // what it scatters
    Rgb emission{0.f};  // Le: a unit of length emits sigmaA times this radiance
    float g = 0;        // mean cosine of the angle by which scattering deflects light, in (-1, 1)

    Rgb sigmaT() const { return sigmaA + sigmaS; }
    bool scatters() const { return !isBlack(sigmaS); }
    // The share of light that passes a distance, which may be infinite.
    Rgb transmittance(float distance) const {
        const Rgb t = sigmaT();
        const auto through = [&](float sigma) { return sigma > 0 ? std::exp(-sigma * distance) : 1; };
        return {through(t.x), through(t.y), through(t.z)};
    }
    // The radiance that a distance emits towards its beginning, of which it absorbs and scatters a part itself.
    Rgb emitted(float distance) const;
    // The share of light from the end of a distance to its beginning that is scattered on the way.
    Rgb scatteredIn(float distance) const { return albedo() * (Rgb(1.f) - transmittance(distance)); }
    // The albedo of single scattering; zero where there is no medium.
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
