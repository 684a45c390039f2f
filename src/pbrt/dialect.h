// pbrt-v3 and pbrt-v4 share most words of their scene formats, but some have different meanings, so a file must be read
// in the dialect that it is written in. docs/pbrt-dialects.md explains the rule and the differences.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "pbrt/source.h"

namespace drc::pbrt {

enum class Dialect { V3, V4 };
std::string_view nameOf(Dialect dialect);

// The dialect to which a directive is exclusive; none if both know it, or neither.
std::optional<Dialect> dialectOfDirective(std::string_view directive);
// The dialect to which a directive's type is exclusive, as in `Film "rgb"`. Types of named materials count as types of
// Material.
std::optional<Dialect> dialectOfType(std::string_view directive, std::string_view type);

// A parameter as written in the file.
struct ParamMark {
    std::string_view typeName, name;
    size_t valueCount = 0;
    std::string_view firstText;  // the first value if it is a string
};
// Parameters are weaker evidence than directives and types: files have some that pbrt ignores.
std::optional<Dialect> dialectOfParam(std::string_view directive, std::string_view type, const ParamMark& param);

// The dialect of a file, and the word that identifies it.
struct DialectFinding {
    Dialect dialect = Dialect::V3;
    std::string word;  // as written; empty if no word identifies the dialect
    SourceLocation where;
    bool weak = false;  // identified by a parameter only

    // For messages: "pbrt-v4, as 'Film "rgb"' in line 3 of a.pbrt tells".
    std::string describe() const;
};

// Throws Error, naming both places, for a word that is exclusive to the other dialect. type empty: the directive
// itself.
void checkDialect(const DialectFinding& finding, std::string_view directive, std::string_view type,
                  const SourcePos& pos);

}  // namespace drc::pbrt
