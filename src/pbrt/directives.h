// The directives of the pbrt format. To add one, add an entry to the table in directives.cpp.
#pragma once
#include <string_view>

#include "pbrt/param_parser.h"
#include "pbrt/scene_builder.h"
#include "pbrt/token_stream.h"

namespace drc::pbrt {

struct DirectiveContext {
    TokenStream& tokens;  // positioned after the directive's name
    SceneBuilder& builder;
    const FileSearch& files;
    const DialectFinding& dialect;
    std::string_view name;
    SourcePos pos;
};

// Where a directive is allowed: before WorldBegin, after it, or anywhere.
enum class DirectiveScope { Options, World, Any };

struct Directive {
    std::string_view name;
    DirectiveScope scope;
    void (*run)(const DirectiveContext&);
};

// Throws Error at the word if there is no such directive.
const Directive& findDirective(const Token& word);

}  // namespace drc::pbrt
