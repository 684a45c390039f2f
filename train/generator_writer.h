// Writes a draft as a pbrt-v3 scene.
#pragma once
#include <filesystem>
#include <string>

#include "generator_draft.h"

namespace drc::interior {

// How the file's world space relates to that of the draft.
struct World {
    bool yUp = false;
    float scale = 1;  // file units per metre
    Placement frame;

    Vec3 vector(const Vec3& v) const;
    Vec3 point(const Vec3& p) const;
};

struct FilmSize {
    int width = 320;
    int height = 240;
};

std::string toPbrt(const Draft& draft, const World& world, const FilmSize& film, const std::string& title);
// Writes scene.pbrt and textures/ to a directory, which is created if necessary. Throws Error.
void writeScene(const std::filesystem::path& directory, const Draft& draft, const std::string& pbrt);

}  // namespace drc::interior
