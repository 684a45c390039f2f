// Parses a directive's parameter list:  "type name" value-or-[values]  "type name" ...
#pragma once
#include <string>

#include "pbrt/color_space.h"
#include "pbrt/dialect.h"
#include "pbrt/file_search.h"
#include "pbrt/param_set.h"
#include "pbrt/token_stream.h"

namespace drc::pbrt {

// How colours of a file are converted to linear RGB.
struct ColorRules {
    Dialect dialect = Dialect::V3;
    // For pbrt-v4 only. Colours of lights are treated differently from those of surfaces: an "rgb" of a light is its
    // radiance, whereas a spectrum or temperature only gives the chromaticity, with a luminance of one.
    const ColorSpace* space = &ColorSpace::srgb();  // of "rgb"
    bool isLight = false;
};

// Parses as long as quoted strings follow. owner ("shape 'sphere'") and pos are those of the directive, for messages.
// files finds the spectra that parameters name. Throws Error at malformed input.
ParamSet parseParams(TokenStream& tokens, const std::string& owner, const SourcePos& pos, const FileSearch& files,
                     const ColorRules& rules = {});

// The two words of a declaration "type name"; empty if they are missing.
struct ParamName {
    std::string type, name;
    bool hasMore = false;  // whether there is a third word
};
ParamName paramNameOf(const std::string& declaration);

}  // namespace drc::pbrt
