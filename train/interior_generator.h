// Closed interiors to learn from: every scene follows from the seed and its number alone, to the byte.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "generator_draft.h"
#include "generator_writer.h"

namespace drc::interior {

struct Interior {
    Draft draft;
    World world;
    std::string pbrt;
};

Interior generateInterior(uint64_t seed, int number, const FilmSize& film);

// What must hold of a scene before it is worth rendering. Empty, or what is wrong.
std::string findFault(const Draft& draft);

// Its files, as directory/room-0001 and so on; returns what was made.
Interior writeInterior(const std::filesystem::path& directory, uint64_t seed, int number, const FilmSize& film);

}  // namespace drc::interior
