#include "pbrt/scene_media.h"

#include <algorithm>

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

bool SceneMedia::isDefined(const std::string& name) const {
    const auto found = entries_.find(name);
    return found != entries_.end() && found->second.defined;
}

void SceneMedia::forgetUndefined(const Medium*& medium) const {
    for (const auto& entry : entries_)
        if (!entry.second.defined && entry.second.medium.get() == medium) medium = nullptr;
}

std::vector<std::shared_ptr<const Medium>> SceneMedia::finish() {
    std::vector<const std::pair<const std::string, Entry>*> missing;
    std::vector<std::string_view> names;
    for (const auto& entry : entries_) {
        if (entry.second.defined)
            names.push_back(entry.first);
        else
            missing.push_back(&entry);
    }
    std::ranges::sort(missing, {}, [](const auto* entry) { return entry->second.order; });
    for (const auto* entry : missing) {
        const std::string complaint = "no medium '" + entry->first + "' is defined",
                          advice = suggestion(entry->first, names);
        if (dialect_ == Dialect::V4) fail(entry->second.pos, complaint + advice);
        warn(entry->second.pos, complaint + "; there is empty space in its place" + advice);
    }
    std::vector<std::shared_ptr<const Medium>> all = std::move(replaced_);
    for (auto& entry : entries_)
        if (entry.second.defined) all.push_back(std::move(entry.second.medium));
    return all;
}

}  // namespace drc::pbrt
