// Curved things that are not triangles in the file: quadrics, subdivision surfaces and curves, as pbrt's own shapes.
#pragma once
#include "generator_pen.h"
#include "generator_rng.h"

namespace drc::interior {

// One of pbrt's quadrics, standing on `base`, at most `size` wide and `height` high.
void drawQuadric(const Pen& pen, const Vec3& base, float size, float height, Rng& rng, int material);
// A soft closed body on `base` from a coarse random cage.
void drawSubdivided(const Pen& pen, const Vec3& base, float size, float height, Rng& rng, int material);
// Blades that fan out of `base`: grass, or dry stems in a vase.
void drawTuft(const Pen& pen, const Vec3& base, float spread, float height, int blades, Rng& rng, int material);

}  // namespace drc::interior
