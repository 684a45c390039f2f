#include "pbrt/scene_media.h"

#include "base/suggest.h"

namespace drc::pbrt {

const Medium* SceneMedia::named(const std::string& name, const SourcePos& pos) {
    if (name.empty()) return nullptr;
    const auto [at, isNew] = entries_.try_emplace(name);
    if (isNew) {
        at->second.pos = pos;
        at->second.order = entries_.size();
    }
    return at->second.medium.get();
}

void SceneMedia::define(const std::string& name, const Medium& medium) {
    Entry& entry = entries_[name];
    if (entry.defined) {
        replaced_.push_back(entry.medium);
        entry = {};
    }
    *entry.medium = medium;
    entry.defined = true;
}

std::vector<std::shared_ptr<const Medium>> SceneMedia::finish() {
    const std::pair<const std::string, Entry>* missing = nullptr;
    std::vector<std::string_view> names;
    for (const auto& entry : entries_) {
        if (entry.second.defined)
            names.push_back(entry.first);
        else if (missing == nullptr || entry.second.order < missing->second.order)
            missing = &entry;
    }
    if (missing)
        fail(missing->second.pos, "no medium '" + missing->first + "' is defined" + suggestion(missing->first, names));
    std::vector<std::shared_ptr<const Medium>> all = std::move(replaced_);
    for (auto& entry : entries_) all.push_back(std::move(entry.second.medium));
    return all;
}

}  // namespace drc::pbrt
