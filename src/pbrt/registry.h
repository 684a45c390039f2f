// The form of every table of named things that a scene can ask for: shapes, materials, textures, ...
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/source.h"
#include "pbrt/suggest.h"

namespace drc::pbrt {

// Make is a function pointer; null: pbrt knows the name, and we have not built the thing.
template <typename Make>
struct Registered {
    std::string_view name;
    Make make;
};

// The maker of that name. Throws Error at pos for a name that pbrt does not know either; for one that is not built,
// warns with the consequence ("the shape is left out") and returns null. kind is for messages: "shape".
template <typename Make>
Make findMaker(std::span<const Registered<Make>> table, const std::string& kind, const std::string& name,
               const SourcePos& pos, const std::string& consequence) {
    std::vector<std::string_view> names;
    for (const Registered<Make>& entry : table) {
        if (entry.name == name) {
            if (entry.make == nullptr) warn(pos, kind + " '" + name + "' is not supported yet; " + consequence);
            return entry.make;
        }
        names.push_back(entry.name);
    }
    fail(pos, "unknown " + kind + " '" + name + "'" + suggestion(name, names));
}

}  // namespace drc::pbrt
