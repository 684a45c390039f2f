// Random closed interiors for training. Every scene is determined, byte for byte, by the seed and its number.
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

// Checks that a scene is worth rendering. Returns what is wrong; empty if nothing is.
std::string findFault(const Draft& draft);

// Writes a room to directory/room-0001 and so on, and returns it.
Interior writeInterior(const std::filesystem::path& directory, uint64_t seed, int number, const FilmSize& film);

}  // namespace drc::interior
