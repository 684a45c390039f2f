// Reads a directive's parameter list:  "type name" value-or-[values]  "type name" ...
#pragma once
#include <string>

#include "pbrt/file_search.h"
#include "pbrt/param_set.h"
#include "pbrt/token_stream.h"

namespace drc::pbrt {

// Reads for as long as quoted strings follow. owner ("shape 'sphere'") and pos are the directive's, for messages.
// files finds the spectra that parameters name. Throws Error at whatever is malformed.
ParamSet parseParams(TokenStream& tokens, const std::string& owner, const SourcePos& pos, const FileSearch& files);

}  // namespace drc::pbrt
