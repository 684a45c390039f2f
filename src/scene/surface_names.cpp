#include "scene/surface_names.h"

namespace drc {

uint32_t SurfaceNames::keep(std::string_view text) {
    if (const auto found = indices_.find(text); found != indices_.end()) return found->second;
    const auto added = indices_.emplace(text, uint32_t(strings_.size())).first;
    strings_.push_back(&added->first);
    return added->second;
}

uint32_t SurfaceNames::add(const SurfaceName& name) {
    rows_.push_back({keep(name.material), keep(name.materialKind), keep(name.shapeKind), keep(name.meshFile),
                     keep(name.file), int32_t(name.line)});
    return uint32_t(rows_.size() - 1);
}

SurfaceName SurfaceNames::at(uint32_t index) const {
    if (index == kNone) return {};
    const Row& row = rows_[index];
    return {*strings_[row.material], *strings_[row.materialKind], *strings_[row.shapeKind],
            *strings_[row.meshFile], *strings_[row.file],         row.line};
}

}  // namespace drc
