// Conversion of colours in scene files to linear RGB, as in pbrt-v3's RGB renderer: integrate against the CIE 1931
// observer, divide by the integral of y, and convert to Rec. 709 primaries. A spectrum that is 1 everywhere therefore
// becomes the colour of the equal-energy illuminant, which is not grey.
#pragma once
#include <string>
#include <vector>

#include "math/vec.h"

namespace drc::pbrt {

struct SpectrumSample {
    float wavelength;  // nm
    float value;
};

// How a spectrum continues beyond its first and last samples: with their values (pbrt-v3, and the built-in tables) or
// with zero (pbrt-v4).
enum class Beyond { Constant, Zero };
// The colour of a spectrum. Samples may be in any order; between them the spectrum is linear. With Beyond::Zero, a
// single sample becomes a triangle that reaches zero one nanometre to either side.
Rgb spectrumToRgb(std::vector<SpectrumSample> samples, Beyond beyond = Beyond::Constant);
// The colour of a reflectance under pbrt-v4's white, D65: a spectrum that is 1 everywhere is white. Clamped to [0, 1],
// because a saturated spectrum might otherwise give components outside, that is, reflect more light than it receives.
Rgb reflectanceToRgb(std::vector<SpectrumSample> samples, Beyond beyond = Beyond::Constant);
// Weights w_i for reflectances sampled at common, ascending wavelengths: colour = sum_i w_i * value_i.
std::vector<Rgb> reflectanceWeights(const std::vector<float>& wavelengths);
// The colour scaled to a luminance of one, as pbrt-v4 does with spectra of lights; black stays black. Components
// outside the gamut of Rec. 709 are clamped first.
Rgb atUnitLuminance(const Rgb& color);
// The colour of a black body whose spectrum is scaled to a maximum of 1. Black for kelvin <= 0.
Rgb blackbodyToRgb(float kelvin);
// Reads "wavelength value" pairs; '#' begins a comment. Throws Error with file and line.
std::vector<SpectrumSample> readSpdFile(const std::string& path);

}  // namespace drc::pbrt
