// Use of a name that is not defined yet. If it is never defined, pbrt-v4 fails, whereas pbrt-v3, which looks names up
// where they are used, warns.
#pragma once
#include <string>

#include "base/error.h"
#include "pbrt/source.h"

namespace drc::pbrt {

// Kinds of things that have names, for messages.
inline constexpr const char* kMaterialName = "material";
inline constexpr const char* kFloatTextureName = "float texture";
inline constexpr const char* kSpectrumTextureName = "spectrum texture";
inline constexpr const char* kObjectName = "object";

// Thrown in pbrt-v4, where the name may be defined later in the file: see LaterNames.
class UndefinedName : public Error {
  public:
    UndefinedName(std::string kindOfName, std::string missing, const SourcePos& at, const std::string& message)
        : Error(at.location(), message, at.excerpt()), kind(std::move(kindOfName)), name(std::move(missing)), pos(at) {}

    std::string kind, name;
    SourcePos pos;  // where the name is used
};

}  // namespace drc::pbrt
