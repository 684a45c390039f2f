// A draft as files that pbrt-v3 reads.
#pragma once
#include <filesystem>
#include <string>

#include "generator_draft.h"

namespace drc::interior {

// How the file's world lies to the draft's.
struct World {
    bool yUp = false;
    float scale = 1;  // file units in a metre
    Placement frame;

    Vec3 vector(const Vec3& v) const;
    Vec3 point(const Vec3& p) const;
};

struct FilmSize {
    int width = 320;
    int height = 240;
};

std::string toPbrt(const Draft& draft, const World& world, const FilmSize& film, const std::string& title);
// scene.pbrt and textures/ in a directory that is made if need be. Throws Error.
void writeScene(const std::filesystem::path& directory, const Draft& draft, const std::string& pbrt);

}  // namespace drc::interior
