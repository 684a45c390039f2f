// Conversion of the colours in scene files to linear RGB, as pbrt-v3's RGB renderer does it: integrate against the CIE
// 1931 observer, divide by the integral of y, and convert to Rec. 709 primaries. A spectrum that is 1 everywhere is
// therefore not grey, but the colour of the equal-energy illuminant.
#pragma once
#include <string>
#include <vector>

#include "math/vec.h"

namespace drc::pbrt {

struct SpectrumSample {
    float wavelength;  // nm
    float value;
};

// How a spectrum continues past its first and last samples: with their values (pbrt-v3, and the built-in tables) or
// with zero (pbrt-v4).
enum class Beyond { Constant, Zero };
// Samples in any order; linear between them. A single sample that is zero beyond is a band of a nanometre.
Rgb spectrumToRgb(std::vector<SpectrumSample> samples, Beyond beyond = Beyond::Constant);
// The colour of a reflectance under pbrt-v4's white, D65: a spectrum that is 1 everywhere is white. Clamped to [0, 1],
// because a saturated spectrum would otherwise reflect more red, green or blue than it receives.
Rgb reflectanceToRgb(std::vector<SpectrumSample> samples, Beyond beyond = Beyond::Constant);
// Weights w_i for reflectances sampled at common, ascending wavelengths: colour = sum_i w_i * value_i.
std::vector<Rgb> reflectanceWeights(const std::vector<float>& wavelengths);
// The colour scaled to a luminance of one, as pbrt-v4's lights do with spectra; black stays black. What lies outside
// the gamut of Rec. 709 is clamped before.
Rgb atUnitLuminance(const Rgb& color);
// A black body with its spectrum scaled to a maximum of 1. Black for kelvin <= 0.
Rgb blackbodyToRgb(float kelvin);
// Reads "wavelength value" pairs; '#' begins a comment. Throws Error with file and line.
std::vector<SpectrumSample> readSpdFile(const std::string& path);

}  // namespace drc::pbrt
