// std::visit for lobes, with the most common ones tested first. For more than a dozen alternatives, std::visit calls
// through a table, which costs more than most lobes and prevents inlining.
#pragma once
#include <utility>

#include "scene/lobes/lobes.h"

namespace drc {

template <class F>
decltype(auto) visitLobe(F&& f, const Lobe& lobe) {
    if (const auto* l = std::get_if<LambertReflection>(&lobe)) return f(*l);
    if (const auto* l = std::get_if<MicrofacetReflection>(&lobe)) return f(*l);
    if (const auto* l = std::get_if<FresnelBlendBase>(&lobe)) return f(*l);
    if (const auto* l = std::get_if<FresnelBlendCoat>(&lobe)) return f(*l);
    return std::visit(std::forward<F>(f), lobe);
}

}  // namespace drc
