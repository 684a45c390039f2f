// Defers whatever uses a name until that name is defined. pbrt-v4 looks names up after it has read the last file, so a
// material may name a texture, and a shape a material, that comes later.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "pbrt/undefined_name.h"

namespace drc::pbrt {

class LaterNames {
  public:
    // A definition of `name` that waits for other names. `make` makes it, or throws UndefinedName while it cannot.
    void define(const std::string& kind, const std::string& name, std::function<void()> make) {
        waiting_.push_back({kind, name, std::move(make)});
    }
    // Something without a name that waits, such as a shape for its material.
    void use(std::function<void()> make) { waiting_.push_back({"", "", std::move(make)}); }

    // Makes all of it, definitions before what uses them, else in the order of the file. Throws UndefinedName at the
    // first use of a name that is defined nowhere, and Error if definitions use each other in a circle.
    void finish();

  private:
    struct Waiting {
        std::string kind, name;
        std::function<void()> make;
    };
    // Throws the reason for which none of these can be made.
    [[noreturn]] static void failStuck(const std::vector<Waiting>& stuck, const std::vector<UndefinedName>& reasons);

    std::vector<Waiting> waiting_;
};

}  // namespace drc::pbrt
