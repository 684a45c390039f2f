// The media of a scene file by their names, which belong to the whole file in both dialects.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pbrt/source.h"
#include "scene/medium.h"

namespace drc::pbrt {

class SceneMedia {
  public:
    // The medium of this name, which may be defined later; null for the empty name.
    const Medium* named(const std::string& name, const SourcePos& pos);
    // A second definition counts from there on.
    void define(const std::string& name, const Medium& medium);
    // All media. Throws Error at the first mention of one that has not been defined.
    std::vector<std::shared_ptr<const Medium>> finish();

  private:
    struct Entry {
        std::shared_ptr<Medium> medium = std::make_shared<Medium>();
        SourcePos pos;     // of its first mention
        size_t order = 0;  // of its first mention
        bool defined = false;
    };
    std::map<std::string, Entry> entries_;
    std::vector<std::shared_ptr<const Medium>> replaced_;
};

}  // namespace drc::pbrt
