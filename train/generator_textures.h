// Small procedural images for surfaces.
#pragma once
#include "generator_draft.h"
#include "generator_rng.h"

namespace drc::interior {

enum class Pattern { Wood, Stripes, Blotches, Bricks, Painting, Tiles, Floral, LeafMask };

// Adds an image and a texture that reads it. `repeats`: tiles per unit of uv. Returns the texture's name.
std::string addImageTexture(Draft& draft, Rng& rng, Pattern pattern, const Rgb& base, float repeats);
// Adds a checkerboard, which needs no image. Returns the texture's name.
std::string addCheckerboard(Draft& draft, const Rgb& a, const Rgb& b, float repeats);

// Encodes an uncompressed 24-bit TGA, which pbrt can read and which needs no library.
std::string encodeTga(const Texture& texture);

}  // namespace drc::interior
