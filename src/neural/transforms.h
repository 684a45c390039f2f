// The network's scale: what a map's numbers become before the network sees them, and back. Used alike by the renderer
// and the trainer. All arrays are planar; m is the mean of a map over its texels and channels.
//   radiance d -> ln(1 + d/(10 m)) - 0.1          distance z -> ln(1 + (z+1)/(10 (mean z + 1))) - 0.1
//   target   p -> ln(1 + p/(10 m))                normals and albedos as they are
// Distances are in units of the mean distance of what the map hit, so that nothing depends on the scene's units.
// A network that sees the albedo of what a map sees works on radiance over albedo: on the light that falls onto those
// surfaces, which is smooth where their colours are not. It also sees which part of it came straight from emitters.
// (Jiang & Kainz, "Deep Radiance Caching: Convolutional Autoencoders Deeper in Ray Tracing", section on the network.)
#pragma once
#include <cstddef>
#include <string>

namespace drc {

inline constexpr int kPlainPlanes = 7;    // radiance R G B, normal x y z, distance
inline constexpr int kGuidedPlanes = 13;  // and albedo R G B, direct light R G B
inline constexpr int kOutputPlanes = 3;
// exp of more than this says only that the network went astray; it must not become infinity.
inline constexpr float kMaxEncoded = 30;

// What a network is shown of one map. Planar.
struct MapView {
    const float* radiance = nullptr;  // [3][texels]
    const float* normal = nullptr;    // [3][texels], in the map's frame, towards its origin; zero on a miss
    const float* distance = nullptr;  // [texels], -1 on a miss
    size_t texels = 0;
    // [3][texels] both, or null: the network sees neither.
    const float* albedo = nullptr;  // in [0, 1]
    const float* direct = nullptr;  // the part of radiance that came to the surface seen straight from emitters
};

// The mean of the array; non-finite and negative values count as 0. 0 for an empty array.
float meanRadiance(const float* radiance, size_t count);

// Writes the input planes, [7][texels], with albedos [13][texels]. Returns the mean m of the radiance, or with albedos
// of radiance over albedo. Whatever is non-finite is taken as nothing: 0, or -1 for a distance; the planes are always
// finite. A black map has m = 0 and a radiance of -0.1 everywhere.
float encodeInput(const MapView& map, float* planes);

// radiance / (albedo + 0.05), and back. What a texel's one ray met may be black where a part of the texel is bright:
// the constant lets that part be seen. All [count]; the result may be the radiance itself.
void divideByAlbedo(const float* radiance, const float* albedo, size_t count, float* result);
void multiplyByAlbedo(const float* radiance, const float* albedo, size_t count, float* result);

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
