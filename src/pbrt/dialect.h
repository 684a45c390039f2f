// pbrt-v3 and pbrt-v4 share most words of their scene formats, but some have different meanings, so a file must be read
// in the dialect that it was written in. docs/pbrt-dialects.md explains the rule and the differences.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "pbrt/source.h"

namespace drc::pbrt {

enum class Dialect { V3, V4 };
std::string_view nameOf(Dialect dialect);

// The dialect that a directive belongs to exclusively; none if both dialects know it, or neither.
std::optional<Dialect> dialectOfDirective(std::string_view directive);
// The dialect that a directive's type belongs to exclusively, as in `Film "rgb"`. Types of named materials count as
// types of Material.
std::optional<Dialect> dialectOfType(std::string_view directive, std::string_view type);

// A parameter as written in the file.
struct ParamMark {
    std::string_view typeName, name;
    size_t valueCount = 0;
    std::string_view firstText;  // the first value, if it is a string
};
// Parameters are weaker evidence than directives and types, because files may contain parameters that pbrt ignores.
std::optional<Dialect> dialectOfParam(std::string_view directive, std::string_view type, const ParamMark& param);

// The dialect of a file, and the word by which it was identified.
struct DialectFinding {
    Dialect dialect = Dialect::V3;
    std::string word;  // as written; empty if no word identifies the dialect
    SourceLocation where;
    bool weak = false;  // identified by a parameter only

    // For messages: "pbrt-v4, as 'Film "rgb"' in line 3 of a.pbrt tells".
    std::string describe() const;
};

// Throws Error, with both locations, if a word belongs exclusively to the other dialect. type: empty to check the
// directive itself.
void checkDialect(const DialectFinding& finding, std::string_view directive, std::string_view type,
                  const SourcePos& pos);

}  // namespace drc::pbrt
