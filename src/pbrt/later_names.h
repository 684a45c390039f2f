// Defers the use of a name until the name is defined. pbrt-v4 looks names up after reading the last file, so a material
// may name a texture, and a shape a material, that is defined later.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "pbrt/undefined_name.h"

namespace drc::pbrt {

class LaterNames {
  public:
    // Defers a definition of `name` that uses names not defined yet. `make` defines it, or throws UndefinedName as long
    // as it cannot.
    void define(const std::string& kind, const std::string& name, std::function<void()> make) {
        waiting_.push_back({kind, name, std::move(make)});
    }
    // Defers something that has no name itself, such as a shape that waits for its material.
    void use(std::function<void()> make) { waiting_.push_back({"", "", std::move(make)}); }

    // Makes everything deferred: definitions before their uses, otherwise in file order. Throws UndefinedName at the
    // first use of a name that is never defined, and Error if definitions form a cycle.
    void finish();

  private:
    struct Waiting {
        std::string kind, name;
        std::function<void()> make;
    };
    // Throws the reason why none of these can be made.
    [[noreturn]] static void failStuck(const std::vector<Waiting>& stuck, const std::vector<UndefinedName>& reasons);

    std::vector<Waiting> waiting_;
};

}  // namespace drc::pbrt
