// Runs map denoisers on training examples, as `drc evaluate` does: which networks fit which maps, and how each scores.
// Examples with one kind of map form a group; groups that contain the same viewpoints can be compared in pairs.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "maps/map_evaluation.h"
#include "neural/unet_weights.h"

namespace drc {

struct EvaluationSettings {
    std::vector<std::string> paths;    // of examples, as for findExamples
    std::vector<std::string> weights;  // weight files. None: the shipped network, if it is found and fits
    bool allInputs = false;            // use every realisation of an example, not only the first
    bool showProgress = true;
};

struct EvaluatedNetwork {
    std::string name;  // the stem of its file; the path if stems are not unique
    std::string path;
    std::shared_ptr<const UNetWeights> weights;
};

struct EvaluatedMethod {
    std::string name;  // "none", "gaussian", or the network's
    std::unique_ptr<MapDenoiser> mapDenoiser;
    std::vector<ExampleScores> scores;  // in the order of EvaluatedGroup::examples
};

struct EvaluatedFile {
    std::shared_ptr<const ExampleSource> source;
    int inputs = 1;  // number of realisations of each example that are used
};

// Where an example is stored, and what distinguishes it from others.
struct ExampleKey {
    size_t file = 0;  // in EvaluatedGroup::files
    int index = 0;    // in the file
    int viewpoint = 0;
    Vec2 film{0.f};
};

struct EvaluatedGroup {
    MapLayout layout{Projection::EqualArea, 32};
    bool guides = true;  // ExampleSource::guides, the same for all of its files
    std::vector<EvaluatedFile> files;
    std::vector<ExampleKey> examples;
    std::vector<EvaluatedMethod> methods;  // none, gaussian, then networks in the order in which they were named

    const std::string& scene(const ExampleKey& key) const { return files[key.file].source->scene(); }
    // "equal-area", or "equal-area 16x16" if the size is not the usual one; also says if there are no albedos.
    std::string name() const;
};

struct Evaluation {
    std::vector<EvaluatedGroup> groups;
    std::vector<EvaluatedNetwork> networks;
    int files = 0, skipped = 0;
    size_t examples = 0;
};

// Runs the evaluation. Files that cannot be read, or contain no example, are skipped with a warning. Throws Error if
// there is no example at all, if a weight file is invalid or named twice, or if a named network fits no group.
Evaluation evaluate(const EvaluationSettings& settings);

// Pairs of indices of examples of `a` and `b` that were captured at one viewpoint: with the same scene name, viewpoint
// number and position on the film. In the order of `a`.
std::vector<std::pair<size_t, size_t>> sharedViewpoints(const EvaluatedGroup& a, const EvaluatedGroup& b);

// `count` examples at random (all, if there are fewer), in their order. The choice depends on the scene's name and the
// viewpoint's number, so that groups with the same viewpoints give the same choice.
std::vector<size_t> chooseExamples(const EvaluatedGroup& group, size_t count, uint64_t seed);

}  // namespace drc
