// Parses a directive's parameter list:  "type name" value-or-[values]  "type name" ...
#pragma once
#include <string>

#include "pbrt/color_space.h"
#include "pbrt/dialect.h"
#include "pbrt/file_search.h"
#include "pbrt/param_set.h"
#include "pbrt/token_stream.h"

namespace drc::pbrt {

// How colours in a file are converted to linear RGB.
struct ColorRules {
    Dialect dialect = Dialect::V3;
    // The following are for pbrt-v4. Colours of lights are treated differently from those of surfaces: an "rgb" of a
    // light is its radiance, whereas a spectrum or temperature gives only the chromaticity, with a luminance of one.
    const ColorSpace* space = &ColorSpace::srgb();  // colour space of "rgb" values
    bool isLight = false;
};

// Parses parameters as long as quoted strings follow. owner ("shape 'sphere'") and pos: the directive, for messages.
// files: finds spectra that parameters name. Throws Error for malformed input.
ParamSet parseParams(TokenStream& tokens, const std::string& owner, const SourcePos& pos, const FileSearch& files,
                     const ColorRules& rules = {});

// The type and the name in a declaration "type name"; empty if they are missing.
struct ParamName {
    std::string type, name;
    bool hasMore = false;  // whether there is a third word
};
ParamName paramNameOf(const std::string& declaration);

}  // namespace drc::pbrt
