// Reads a directive's parameter list:  "type name" value-or-[values]  "type name" ...
#pragma once
#include <string>

#include "pbrt/color_space.h"
#include "pbrt/dialect.h"
#include "pbrt/file_search.h"
#include "pbrt/param_set.h"
#include "pbrt/token_stream.h"

namespace drc::pbrt {

// How what a file says of a colour becomes linear RGB.
struct ColorRules {
    Dialect dialect = Dialect::V3;
    // The rest is pbrt-v4's. Colours of lights are told from those of surfaces: an "rgb" of light is the colour of it,
    // a spectrum or a temperature gives the colour alone, with a luminance of one.
    const ColorSpace* space = &ColorSpace::srgb();  // of "rgb"
    bool isLight = false;
};

// Reads for as long as quoted strings follow. owner ("shape 'sphere'") and pos are the directive's, for messages.
// files finds the spectra that parameters name. Throws Error at whatever is malformed.
ParamSet parseParams(TokenStream& tokens, const std::string& owner, const SourcePos& pos, const FileSearch& files,
                     const ColorRules& rules = {});

// The two words of a declaration, "type name"; empty if they are missing.
struct ParamName {
    std::string type, name;
    bool hasMore = false;  // there is a third word
};
ParamName paramNameOf(const std::string& declaration);

}  // namespace drc::pbrt
