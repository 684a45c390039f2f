#include "pbrt/directive_form.h"

#include <algorithm>
#include <iterator>

namespace drc::pbrt {
namespace {

constexpr DirectiveForm kForms[] = {
    {"Accelerator", 1, 0}, {"AreaLightSource", 1, 0}, {"Attribute", 1, -1},       {"Camera", 1, 0},
    {"Film", 1, 0},        {"Integrator", 1, 0},      {"LightSource", 1, 0},      {"MakeNamedMaterial", 1, -1},
    {"Material", 1, 0},    {"Option", 0, -1},         {"MakeNamedMedium", 1, -1}, {"PixelFilter", 1, 0},
    {"Sampler", 1, 0},     {"Shape", 1, 0},           {"Texture", 3, 2},
};

}  // namespace

const DirectiveForm* formOf(std::string_view directive) {
    const auto* form = std::ranges::find(kForms, directive, &DirectiveForm::directive);
    return form == std::end(kForms) ? nullptr : form;
}

}  // namespace drc::pbrt
