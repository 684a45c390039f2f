// The media of a scene file by name. In both dialects, the names belong to the whole file.
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

    // The medium with this name, which may be defined later; null for the empty name.
    const Medium* named(const std::string& name, const SourcePos& pos);
    // Defines a medium. If the name is already defined, the new medium applies only to later uses of the name.
    void define(const std::string& name, const Medium& medium);
    bool isDefined(const std::string& name) const;
    // Returns all defined media. If an undefined name was used, throws Error at its first use in pbrt-v4, and warns in
    // pbrt-v3; then forgetUndefined() must have been called on all pointers that named() returned.
    std::vector<std::shared_ptr<const Medium>> finish();
    // Replaces a pointer to an undefined medium by null (empty space). Call before finish().
    void forgetUndefined(const Medium*& medium) const;

  private:
    struct Entry {
        std::shared_ptr<Medium> medium = std::make_shared<Medium>();
        SourcePos pos;     // of the first use
        size_t order = 0;  // of the first use, among all names
        bool defined = false;
    };
    Dialect dialect_;
    std::map<std::string, Entry> entries_;
    std::vector<std::shared_ptr<const Medium>> replaced_;
};

}  // namespace drc::pbrt
