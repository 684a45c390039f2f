// The encoding of radiance maps for the network, and its inverse, used by the renderer and by the trainer. All arrays
// are planar. With m the mean of a map's radiance over texels and channels:
//   radiance d -> ln(1 + d/(10 m)) - 0.1          distance z -> ln(1 + (z+1)/(10 (mean z + 1))) - 0.1
//   target   p -> ln(1 + p/(10 m))                normals and albedos are unchanged
// Distances are first divided by the mean distance of the map's hits, so that the scene's units do not matter.
// A network with albedo inputs works on radiance demodulated by albedo, that is, on the light incident on the surfaces
// that the map sees, which is smooth even where their colours are not. Its inputs also contain the part of this light
// that came directly from emitters. (Jiang & Kainz, "Deep Radiance Caching: Convolutional Autoencoders Deeper in Ray
// Tracing", section on the network.)
#pragma once
#include <cstddef>
#include <string>

namespace drc {

inline constexpr int kPlainPlanes = 7;    // radiance R G B, normal x y z, distance
inline constexpr int kGuidedPlanes = 13;  // plain planes, then albedo R G B, direct light R G B
inline constexpr int kOutputPlanes = 3;
// Upper clamp on encoded values before exp(), so that a diverging network does not produce infinity.
inline constexpr float kMaxEncoded = 30;

// The network's inputs for one map, as planar arrays.
struct MapView {
    const float* radiance = nullptr;  // [3][texels]
    const float* normal = nullptr;    // [3][texels], in the map's frame, facing its origin; zero if nothing was hit
    const float* distance = nullptr;  // [texels], -1 if nothing was hit
    size_t texels = 0;
    // [3][texels] each; both null if the network does not use them.
    const float* albedo = nullptr;  // in [0, 1]
    const float* direct = nullptr;  // the part of radiance that reached the visible surface directly from emitters
};

// Mean of the array. Non-finite and negative values count as 0. Returns 0 for an empty array.
float meanRadiance(const float* radiance, size_t count);

// Writes the input planes: [7][texels], or [13][texels] if `map` has albedos. Returns m, the mean of the radiance (with
// albedos, of the demodulated radiance). Replaces non-finite values by 0, or by -1 for distances, so that the planes
// are always finite. A black map has m = 0 and an encoded radiance of -0.1 everywhere.
float encodeInput(const MapView& map, float* planes);

// Demodulation, radiance / (albedo + 0.05), and its inverse. The constant 0.05 preserves the light of bright texels
// whose single ray happened to hit a black surface. All arrays are [count]; `result` may be `radiance` itself.
void divideByAlbedo(const float* radiance, const float* albedo, size_t count, float* result);
void multiplyByAlbedo(const float* radiance, const float* albedo, size_t count, float* result);

// Inputs to hide from a network, to measure what normals and distances contribute (the paper's section on ablation).
enum class Ablation { None, Normals, Distance, Both };
// "none", "normals", "distance", "both"; throws drc::Error for any other name.
Ablation parseAblation(const std::string& name);
std::string ablationName(Ablation ablation);
// Sets the hidden planes of encodeInput()'s result to zero.
void ablate(Ablation ablation, size_t texels, float* planes);

// Encodes a target's radiance with the mean m of its input; all zero if the mean is 0.
void encodeTarget(const float* radiance, size_t count, float mean, float* encoded);

// The inverse of encodeTarget(): (exp(y) - 1) 10 m, never negative and always finite.
void decodeOutput(const float* encoded, size_t count, float mean, float* radiance);

}  // namespace drc
