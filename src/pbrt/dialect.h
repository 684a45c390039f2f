// pbrt-v3's and pbrt-v4's scene formats share most of their words and mean different things by some of them: a file
// must be read as the one that it is written in. docs/pbrt-dialects.md has the rule and the differences.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "pbrt/source.h"

namespace drc::pbrt {

enum class Dialect { V3, V4 };
std::string_view nameOf(Dialect dialect);

// Which of the two alone knows a word; none: both do, or neither.
std::optional<Dialect> dialectOfDirective(std::string_view directive);
// A directive's type: that of `Film "rgb"`. A named material's type counts as Material's.
std::optional<Dialect> dialectOfType(std::string_view directive, std::string_view type);

// A parameter as it is written, before anything is made of it.
struct ParamMark {
    std::string_view typeName, name;
    size_t valueCount = 0;
    std::string_view firstText;  // the first value, if that is a string
};
// Parameters are weaker evidence than directives and types: files have some that pbrt ignores.
std::optional<Dialect> dialectOfParam(std::string_view directive, std::string_view type, const ParamMark& param);

// What a file is written in, and the word that tells.
struct DialectFinding {
    Dialect dialect = Dialect::V3;
    std::string word;  // as written; empty: nothing tells
    SourceLocation where;
    bool weak = false;  // a parameter's word

    // For messages: "pbrt-v4, as 'Film "rgb"' in line 3 of a.pbrt tells".
    std::string describe() const;
};

// Throws Error, naming both places, for a word that only the other dialect has. type empty: the directive itself.
void checkDialect(const DialectFinding& finding, std::string_view directive, std::string_view type,
                  const SourcePos& pos);

}  // namespace drc::pbrt
