// For tests: a folder with examples of two projections, three of whose viewpoints both have, and small networks.
#pragma once
#include <string>
#include <vector>

#include "app/evaluation.h"
#include "base/folder_testing.h"
#include "maps/example_testing.h"

namespace drc {

class EvaluationTest : public FolderTest {
  protected:
    // A name that must be escaped.
    static constexpr const char* kHostileScene = "<b>&\"two'";

    EvaluationTest() {
        std::filesystem::create_directories(path("ea"));
        std::filesystem::create_directories(path("ll"));
        writeShard(path("ea/one.examples"), "one", kEqualArea, examples(kEqualArea, {1, 2, 3}));
        writeShard(path("ea/two.examples"), kHostileScene, kEqualArea, examples(kEqualArea, {4, 5}));
        writeShard(path("ll/one.examples"), "one", kLatLong, examples(kLatLong, {1, 2, 3}));
        // The numbers of the others, but at other places on the film.
        writeShard(path("ll/two.examples"), kHostileScene, kLatLong, examples(kLatLong, {6, 7}));
    }

    static std::vector<TrainingExample> examples(const MapLayout& layout, const std::vector<unsigned>& seeds) {
        std::vector<TrainingExample> result;
        for (const unsigned seed : seeds) result.push_back(randomExample(layout, 2, seed));
        return result;
    }

    std::string network(const std::string& name, const std::string& projection, uint64_t seed, int size = 32,
                        int planes = kPlainPlanes) const {
        UNetShape shape;
        shape.width = 4;
        shape.levels = 2;
        shape.size = size;
        shape.inputs = planes;
        std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
        UNetWeights::random(shape, seed)->save(path(name), {{"projection", projection}, {"commit", "abc<def"}});
        return path(name);
    }

    Evaluation run(const std::vector<std::string>& weights) const {
        return evaluate({{path("ea"), path("ll")}, weights, false, false});
    }

    const MapLayout kEqualArea{Projection::EqualArea, 32}, kLatLong{Projection::LatLong, 32};
};

}  // namespace drc
