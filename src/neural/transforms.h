// The network's scale: what a map's numbers become before the network sees them, and back. Used alike by the renderer
// and the trainer. All arrays are planar; m is the mean of a map over its texels and channels.
//   radiance d -> ln(1 + d/(10 m)) - 0.1          distance z -> ln(1 + (z+1)/(10 (mean z + 1))) - 0.1
//   target   p -> ln(1 + p/(10 m))                normals as they are
// Distances are in units of the mean distance of what the map hit, so that nothing depends on the scene's units.
// (Jiang & Kainz, "Deep Radiance Caching: Convolutional Autoencoders Deeper in Ray Tracing", section on the network.)
#pragma once
#include <cstddef>
#include <string>

namespace drc {

inline constexpr int kInputPlanes = 7;
inline constexpr int kOutputPlanes = 3;

// The mean of the array; non-finite and negative values count as 0. 0 for an empty array.
float meanRadiance(const float* radiance, size_t count);

// Writes the 7 input planes: radiance R G B, normal x y z, distance. Sizes: radiance and normal [3][texels], distance
// [texels] (-1 where nothing was hit), planes [7][texels]. The normal is in the map's frame, towards its origin, zero
// on a miss. Returns the radiance's mean m. Whatever is non-finite is taken as nothing: 0, or -1 for a distance; the
// planes are always finite. A black map has m = 0 and a radiance of -0.1 everywhere.
float encodeInput(const float* radiance, const float* normal, const float* distance, size_t texels, float* planes);

// What a network is not shown, to learn what the normals and distances of a map are worth (section on ablation).
enum class Ablation { None, Normals, Distance, Both };
// "none", "normals", "distance", "both"; throws drc::Error for any other name.
Ablation parseAblation(const std::string& name);
std::string ablationName(Ablation ablation);
// Sets the planes of encodeInput that are left out to zero.
void ablate(Ablation ablation, size_t texels, float* planes);

// Radiance -> the network's output scale; 0 throughout if mean is 0.
void encodeTarget(const float* radiance, size_t count, float mean, float* encoded);

// The inverse: (exp(y) - 1) 10 m, never negative, always finite.
void decodeOutput(const float* encoded, size_t count, float mean, float* radiance);

}  // namespace drc
