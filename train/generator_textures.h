// Small images to put on surfaces, made from noise and shapes.
#pragma once
#include "generator_draft.h"
#include "generator_rng.h"

namespace drc::interior {

enum class Pattern { Wood, Stripes, Blotches, Bricks, Painting, Tiles, Floral, LeafMask };

// Adds an image and the texture that reads it; `repeats` is in tiles per unit of uv. Returns the texture's name.
std::string addImageTexture(Draft& draft, Rng& rng, Pattern pattern, const Rgb& base, float repeats);
// A checkerboard needs no image.
std::string addCheckerboard(Draft& draft, const Rgb& a, const Rgb& b, float repeats);

// The bytes of an uncompressed 24 bit TGA: pbrt reads it, and it needs no library.
std::string encodeTga(const Texture& texture);

}  // namespace drc::interior
