// LDR-FLIP: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for
// Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 2020.
#pragma once
#include "image/convolution.h"
#include "image/image.h"

namespace drc {

// The paper's viewing condition: a 0.7 m wide 4K monitor seen from 0.7 m.
inline constexpr float kFlipPixelsPerDegree = 67;

// The error at each pixel, from 0 (not visible) to 1, of two linear RGB images of one size, each clamped to [0, 1].
// Throws Error if the sizes differ.
Plane flipMap(const Image& reference, const Image& test, float pixelsPerDegree = kFlipPixelsPerDegree);
// Mean of flipMap.
double flip(const Image& reference, const Image& test, float pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace drc
