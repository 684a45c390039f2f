// A copy-on-write map from names to shared objects. AttributeBegin copies it, but few blocks add names.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace drc::pbrt {

template <typename T>
class NamedMap {
  public:
    // Null if there is no such name.
    std::shared_ptr<const T> find(const std::string& name) const {
        const auto found = entries_->find(name);
        return found == entries_->end() ? nullptr : found->second;
    }
    // Does not affect copies of this map made earlier.
    void set(const std::string& name, std::shared_ptr<const T> value) {
        if (entries_.use_count() > 1) entries_ = std::make_shared<Entries>(*entries_);
        (*entries_)[name] = std::move(value);
    }
    std::vector<std::string_view> names() const {
        std::vector<std::string_view> result;
        for (const auto& entry : *entries_) result.push_back(entry.first);
        return result;
    }

  private:
    using Entries = std::map<std::string, std::shared_ptr<const T>>;
    std::shared_ptr<Entries> entries_ = std::make_shared<Entries>();
};

}  // namespace drc::pbrt
