// The media of a scene file by their names, which belong to the whole file in both dialects.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pbrt/dialect.h"
#include "pbrt/source.h"
#include "scene/media/medium.h"

namespace drc::pbrt {

class SceneMedia {
  public:
    explicit SceneMedia(Dialect dialect) : dialect_(dialect) {}

    // The medium of this name, which may be defined later; null for the empty name.
    const Medium* named(const std::string& name, const SourcePos& pos);
    // A second definition counts from there on.
    void define(const std::string& name, const Medium& medium);
    bool isDefined(const std::string& name) const;
    // All media that are defined. If one is mentioned that is not: throws Error at its first mention in pbrt-v4; in
    // pbrt-v3 there is a warning, and forgetUndefined() must have been called for all that got it from named().
    std::vector<std::shared_ptr<const Medium>> finish();
    // Puts empty space in place of a medium that is not defined. Before finish().
    void forgetUndefined(const Medium*& medium) const;

  private:
    struct Entry {
        std::shared_ptr<Medium> medium = std::make_shared<Medium>();
        SourcePos pos;     // of its first mention
        size_t order = 0;  // of its first mention
        bool defined = false;
    };
    Dialect dialect_;
    std::map<std::string, Entry> entries_;
    std::vector<std::shared_ptr<const Medium>> replaced_;
};

}  // namespace drc::pbrt
