// The forms of directives, for readers that look at a scene's tokens without building the scene.
#pragma once
#include <string_view>

namespace drc::pbrt {

// A directive with parameters: how many strings stand before them, and which of these is the type.
struct DirectiveForm {
    std::string_view directive;
    int strings;
    int type;  // index of the string with the type; -1: none
};

// Null for a word that is no directive, or one without parameters.
const DirectiveForm* formOf(std::string_view directive);

}  // namespace drc::pbrt
