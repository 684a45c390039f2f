// Curved shapes that stay analytic in the file: quadrics, subdivision surfaces and curves.
#pragma once
#include "generator_pen.h"
#include "generator_rng.h"

namespace drc::interior {

// A random quadric standing on `base`, at most `size` wide and `height` high.
void drawQuadric(const Pen& pen, const Vec3& base, float size, float height, Rng& rng, int material);
// A smooth closed body on `base`, from a coarse random control cage.
void drawSubdivided(const Pen& pen, const Vec3& base, float size, float height, Rng& rng, int material);
// A tuft of blades that fan out from `base`: grass, or dry stems in a vase.
void drawTuft(const Pen& pen, const Vec3& base, float spread, float height, int blades, Rng& rng, int material);

}  // namespace drc::interior
