// std::visit for lobes, with the commonest ones first: beyond a dozen kinds of lobe the library calls through a table,
// which costs more than what most lobes do, and which the compiler cannot see through.
#pragma once
#include <utility>

#include "scene/lobes.h"

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
