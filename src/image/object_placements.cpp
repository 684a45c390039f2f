#include "image/object_placements.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "base/error.h"

namespace drc {

void ObjectPlacements::add(uint32_t object, const Transform& toWorld) {
    assert(object > 0 && object <= kMostObjects);
    if (toWorld.isIdentity()) return;
    Row row{float(object), {}};
    for (int i = 0; i < 12; ++i) row.toWorld[size_t(i)] = toWorld.at(i / 4, i % 4);
    const bool isLast = rows_.empty() || rows_.back().object < row.object;
    rows_.insert(isLast ? rows_.end() : std::ranges::lower_bound(rows_, row.object, {}, &Row::object), row);
}

Transform ObjectPlacements::of(uint32_t object) const {
    const auto found = std::ranges::lower_bound(rows_, float(object), {}, &Row::object);
    if (found == rows_.end() || found->object != float(object)) return {};
    std::array<double, 16> entries{};
    std::ranges::copy(found->toWorld, entries.begin());
    entries[15] = 1;
    return Transform(entries);
}

ObjectPlacements ObjectPlacements::only(const std::set<uint32_t>& objects) const {
    ObjectPlacements some;
    for (const Row& row : rows_)
        if (objects.contains(uint32_t(row.object))) some.rows_.push_back(row);
    return some;
}

ObjectPlacements ObjectPlacements::with(const ObjectPlacements& others) const {
    ObjectPlacements all;
    std::ranges::merge(rows_, others.rows_, std::back_inserter(all.rows_), {}, &Row::object, &Row::object);
    return all;
}

ExrAttribute ObjectPlacements::attribute() const {
    static_assert(sizeof(Row) == 13 * sizeof(float));
    std::string bytes(rows_.size() * sizeof(Row), '\0');
    if (!rows_.empty()) std::memcpy(bytes.data(), rows_.data(), bytes.size());
    return {"floatvector", bytes};
}

ObjectPlacements ObjectPlacements::in(const ExrAttributes& attributes) {
    ObjectPlacements all;
    const auto found = attributes.find(kAttribute);
    if (found == attributes.end()) return all;
    const std::string& bytes = found->second.value;
    const auto require = [](bool isSound) {
        if (!isSound) throw Error(std::string("its attribute ") + kAttribute + " is damaged");
    };
    require(found->second.type == "floatvector" && bytes.size() % sizeof(Row) == 0);
    all.rows_.resize(bytes.size() / sizeof(Row));
    if (!bytes.empty()) std::memcpy(all.rows_.data(), bytes.data(), bytes.size());
    float before = 0;
    for (const Row& row : all.rows_) {
        require(row.object > before && row.object <= float(kMostObjects) && row.object == std::floor(row.object));
        require(std::ranges::all_of(row.toWorld, [](float v) { return std::isfinite(v); }));
        before = row.object;
    }
    return all;
}

}  // namespace drc
