// Tables of the types that a scene may name: shapes, materials, textures, ...
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/suggest.h"
#include "pbrt/source.h"

namespace drc::pbrt {

// Make: a function pointer, which is null for types that pbrt has but DRC does not support.
template <typename Make>
struct Registered {
    std::string_view name;
    Make make;
};

// Finds the factory function of a type. Throws Error at pos for types that are not in the table. For unsupported types,
// warns once, with the consequence ("the shape is left out"), and returns null. kind: for messages ("shape").
template <typename Make>
Make findMaker(std::span<const Registered<Make>> table, const std::string& kind, const std::string& name,
               const SourcePos& pos, const std::string& consequence) {
    std::vector<std::string_view> names;
    for (const Registered<Make>& entry : table) {
        if (entry.name == name) {
            if (entry.make == nullptr) warnOnce(pos, kind + " '" + name + "' is not supported yet; " + consequence);
            return entry.make;
        }
        names.push_back(entry.name);
    }
    fail(pos, "unknown " + kind + " '" + name + "'" + suggestion(name, names));
}

}  // namespace drc::pbrt
