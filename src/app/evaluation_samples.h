// The maps of some examples as pictures, for the page of an evaluation: the captured map, the result of each method,
// and its difference from the target.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "app/evaluation.h"

namespace drc {

// How many examples of each group are shown, which choice of them (see chooseExamples), and the folder of the PNG
// files.
struct SampleSettings {
    size_t count = 12;
    uint64_t seed = 0;
    std::string folder;
};

// Writes the pictures of `group` and returns an array with an object for each example: its place, the names of its
// pictures in the folder, and the scores of each method. group: its index, which the names begin with. Throws Error as
// ExampleSource::load and writePng do.
nlohmann::ordered_json writeSamples(const Evaluation& evaluation, size_t group, const SampleSettings& settings);

// Writes the scale of the false colours of errors, and returns its name in the folder.
std::string writeErrorScale(const SampleSettings& settings);

}  // namespace drc
