// drc-generate: writes random rooms for training.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "base/error.h"
#include "interior_generator.h"

namespace {

drc::interior::FilmSize parseResolution(const std::string& text) {
    drc::interior::FilmSize size;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) != 2 || size.width < 1 ||
        size.height < 1) {
        throw drc::Error(fmt::format("--resolution {}: expected WIDTHxHEIGHT, such as 320x240", text));
    }
    return size;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Writes furnished rooms as pbrt-v3 scenes, for training. The same seed gives the same files."};
    app.footer("Example:\n  drc-generate --count 32 --seed 1 -o data/rooms");
    int count = 32;
    int first = 1;
    uint64_t seed = 1;
    bool quiet = false;
    std::string directory, resolution = "320x240";
    app.add_option("--count", count, "Number of rooms")->check(CLI::Range(1, 1000000))->capture_default_str();
    app.add_option("--first", first, "Number of the first room")->check(CLI::Range(1, 1000000))->capture_default_str();
    app.add_option("--seed", seed, "Seed of all random choices")->capture_default_str();
    app.add_option("--resolution", resolution, "Film size written to the scenes")->capture_default_str();
    app.add_option("-o,--output", directory, "Directory to write room-0001/scene.pbrt and so on into")->required();
    app.add_flag("-q,--quiet", quiet, "Do not list the rooms");
    CLI11_PARSE(app, argc, argv);
    try {
        const drc::interior::FilmSize film = parseResolution(resolution);
        for (int number = first; number < first + count; ++number) {
            const drc::interior::Interior room = drc::interior::writeInterior(directory, seed, number, film);
            if (!quiet) fmt::print("room-{:04}: {}\n", number, room.draft.summary);
        }
    } catch (const drc::Error& e) {
        fmt::print(stderr, "drc-generate: {}\n", e.what());
        return 1;
    }
    return 0;
}
