// Colours as scene files write them, turned into linear RGB the way pbrt-v3's RGB renderer does: integrated against
// the CIE 1931 observer, divided by the integral of y, and taken to Rec. 709 primaries. A spectrum that is 1
// everywhere is therefore not grey but the colour of the equal-energy illuminant.
#pragma once
#include <string>
#include <vector>

#include "math/vec.h"

namespace drc::pbrt {

struct SpectrumSample {
    float wavelength;  // nm
    float value;
};

// Samples in any order, linear in between, constant beyond the first and the last.
Rgb spectrumToRgb(std::vector<SpectrumSample> samples);
// What a surface of that reflectance is under pbrt-v4's white light, D65: a spectrum that is 1 everywhere is white.
Rgb reflectanceToRgb(std::vector<SpectrumSample> samples);
// The same colour with a luminance of one, which is what pbrt-v4's lights make of any spectrum; black stays black.
Rgb atUnitLuminance(const Rgb& color);
// A black body whose spectrum is scaled to a maximum of 1. kelvin <= 0 is black.
Rgb blackbodyToRgb(float kelvin);
// Reads "wavelength value" pairs; '#' begins a comment. Throws Error with file and line.
std::vector<SpectrumSample> readSpdFile(const std::string& path);

}  // namespace drc::pbrt
