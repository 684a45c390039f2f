// Runs map denoisers over examples, as `drc evaluate` does: which networks fit which maps, and what each scores.
// Examples of one kind of map form a group; of several groups, those that hold the same viewpoints can be compared in
// pairs.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "cache/map_evaluation.h"
#include "neural/unet_weights.h"

namespace drc {

struct EvaluationSettings {
    std::vector<std::string> paths;    // of examples, as findExamples takes them
    std::vector<std::string> weights;  // files of networks. None: the shipped one, where it is found and fits
    bool allInputs = false;            // every realisation of an example, not the first alone
    bool showProgress = true;
};

struct EvaluatedNetwork {
    std::string name;  // its file's stem; of files with one stem, their paths
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
    int inputs = 1;  // realisations of each example that were taken
};

// Where an example is, and what tells it from others.
struct ExampleKey {
    size_t file = 0;  // in EvaluatedGroup::files
    int index = 0;    // in the file
    int viewpoint = 0;
    Vec2 film{0.f};
};

struct EvaluatedGroup {
    MapLayout layout{Projection::EqualArea, 32};
    bool guides = true;  // ExampleSource::guides, of all of its files
    std::vector<EvaluatedFile> files;
    std::vector<ExampleKey> examples;
    std::vector<EvaluatedMethod> methods;  // none, gaussian, networks in the order of their naming

    const std::string& scene(const ExampleKey& key) const { return files[key.file].source->scene(); }
    // "equal-area", or "equal-area 16x16" where a size must be told from the usual one; says if there are no
    // albedos.
    std::string name() const;
};

struct Evaluation {
    std::vector<EvaluatedGroup> groups;
    std::vector<EvaluatedNetwork> networks;
    int files = 0, skipped = 0;
    size_t examples = 0;
};

// Files that cannot be read, or hold no example, are skipped with a warning. Throws Error if there is no example at
// all, if a file of weights is none or is named twice, and if a named network fits no group.
Evaluation evaluate(const EvaluationSettings& settings);

// Indices of examples of `a` and of `b` that were captured at one viewpoint: with the same name of the scene, number of
// the viewpoint and place on the film. In the order of `a`.
std::vector<std::pair<size_t, size_t>> sharedViewpoints(const EvaluatedGroup& a, const EvaluatedGroup& b);

// `count` examples at random (all, if there are fewer), in their order. A viewpoint is chosen by its scene's name and
// its own number, so that groups with the same viewpoints give the same choice.
std::vector<size_t> chooseExamples(const EvaluatedGroup& group, size_t count, uint64_t seed);

}  // namespace drc
