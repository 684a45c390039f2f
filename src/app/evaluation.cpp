#include "app/evaluation.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include "app/models.h"
#include "base/error.h"
#include "base/log.h"
#include "base/progress.h"
#include "maps/network_map_denoiser.h"
#include "math/rng.h"

namespace drc {
namespace {

constexpr int kUsualSize = 32;

// Names each network by the stem of its file, or by its path if two methods would have the same name.
void nameNetworks(std::vector<EvaluatedNetwork>& networks) {
    namespace fs = std::filesystem;
    std::map<std::string, int> uses{{"none", 1}, {"gaussian", 1}};
    for (EvaluatedNetwork& network : networks) ++uses[network.name = fs::path(network.path).stem().string()];
    for (EvaluatedNetwork& network : networks)
        if (uses[network.name] > 1) network.name = network.path;
}

std::vector<EvaluatedNetwork> loadNetworks(const std::vector<std::string>& named) {
    std::vector<std::string> paths;
    for (const std::string& weights : named) paths.push_back(findWeights(weights));
    if (named.empty()) {
        try {
            paths.push_back(findWeights(""));
        } catch (const Error&) {
            logInfo("the network is left out: no weights were found; name them with --weights");
        }
    }
    std::vector<EvaluatedNetwork> networks;
    for (const std::string& path : paths) {
        if (std::count(paths.begin(), paths.end(), path) > 1) throw Error("the weights " + path + " are named twice");
        networks.push_back({"", path, UNetWeights::load(path)});
    }
    nameNetworks(networks);
    return networks;
}

// Groups are kept in the order in which their first files appear.
EvaluatedGroup& groupOf(const ExampleSource& source, std::vector<EvaluatedGroup>& groups) {
    const MapLayout& layout = source.layout();
    for (EvaluatedGroup& group : groups)
        if (group.layout.projection() == layout.projection() && group.layout.size() == layout.size() &&
            group.guides == source.guides())
            return group;
    EvaluatedGroup& group = groups.emplace_back();
    group.layout = layout;
    group.guides = source.guides();
    return group;
}

void openFiles(const EvaluationSettings& settings, const std::vector<std::string>& paths, Evaluation& result) {
    for (const std::string& path : paths) {
        try {
            std::shared_ptr<const ExampleSource> source = openExamples(path);
            if (source->count() == 0) throw Error(SourceLocation{path}, "no examples in it");
            groupOf(*source, result.groups).files.push_back({source, settings.allInputs ? source->inputs() : 1});
            ++result.files;
        } catch (const Error& e) {
            logWarning(std::string(e.what()) + "; skipped");
            ++result.skipped;
        }
    }
    if (result.files == 0) throw Error("no examples to evaluate; `drc reference` writes them");
}

void makeMethods(bool networksNamed, Evaluation& result) {
    for (EvaluatedGroup& group : result.groups) {
        group.methods.push_back({"none", makeIdentityMapDenoiser(), {}});
        group.methods.push_back({"gaussian", makeGaussianMapDenoiser(1), {}});
    }
    std::vector<EvaluatedNetwork> used;
    for (EvaluatedNetwork& network : result.networks) {
        std::string why;
        bool fits = false;
        for (EvaluatedGroup& group : result.groups) {
            try {
                if (!group.guides && network.weights->shape().inputs == kGuidedPlanes)
                    throw Error("the network sees albedos and direct light, and these examples have none");
                group.methods.push_back({network.name, makeNetworkMapDenoiser(network.weights, group.layout), {}});
                fits = true;
            } catch (const Error& error) {
                why = error.what();
            }
        }
        if (fits)
            used.push_back(std::move(network));
        else if (networksNamed)
            throw Error(SourceLocation{network.path}, why);
        else  // the shipped weights are made for one kind of map
            logInfo("the network is left out: " + why + "; name others with --weights");
    }
    result.networks = std::move(used);
}

void runMethods(const EvaluationSettings& settings, Evaluation& result) {
    Progress progress("files", result.files, settings.showProgress ? ProgressMode::Auto : ProgressMode::Quiet);
    for (EvaluatedGroup& group : result.groups) {
        std::vector<const MapDenoiser*> mapDenoisers;
        for (const EvaluatedMethod& method : group.methods) mapDenoisers.push_back(method.mapDenoiser.get());
        for (size_t f = 0; f < group.files.size(); ++f) {
            const EvaluatedFile& file = group.files[f];
            const auto evaluated = evaluateMapDenoisers(*file.source, mapDenoisers, file.inputs);
            for (size_t i = 0; i < evaluated.size(); ++i) {
                group.examples.push_back({f, int(i), evaluated[i].viewpoint, evaluated[i].film});
                for (size_t m = 0; m < group.methods.size(); ++m)
                    group.methods[m].scores.push_back(evaluated[i].scores[m]);
            }
            progress.add();
        }
        result.examples += group.examples.size();
    }
}

}  // namespace

std::string EvaluatedGroup::name() const {
    const std::string projection = projectionName(layout.projection());
    const std::string size = layout.size() == kUsualSize ? "" : fmt::format(" {0}x{0}", layout.size());
    return projection + size + (guides ? "" : " without albedos");
}

Evaluation evaluate(const EvaluationSettings& settings) {
    Evaluation result;
    result.networks = loadNetworks(settings.weights);
    openFiles(settings, findExamples(settings.paths), result);
    makeMethods(!settings.weights.empty(), result);
    runMethods(settings, result);
    return result;
}

std::vector<std::pair<size_t, size_t>> sharedViewpoints(const EvaluatedGroup& a, const EvaluatedGroup& b) {
    using Viewpoint = std::tuple<std::string, int, float, float>;
    const auto viewpoint = [](const EvaluatedGroup& group, size_t i) {
        const ExampleKey& key = group.examples[i];
        return Viewpoint{group.scene(key), key.viewpoint, key.film.x, key.film.y};
    };
    std::map<Viewpoint, size_t> inB;
    for (size_t i = 0; i < b.examples.size(); ++i) inB.emplace(viewpoint(b, i), i);
    std::vector<std::pair<size_t, size_t>> shared;
    for (size_t i = 0; i < a.examples.size(); ++i)
        if (const auto found = inB.find(viewpoint(a, i)); found != inB.end()) {
            shared.emplace_back(i, found->second);
            inB.erase(found);  // each once, even if a scene was given twice
        }
    return shared;
}

std::vector<size_t> chooseExamples(const EvaluatedGroup& group, size_t count, uint64_t seed) {
    std::vector<std::pair<uint64_t, size_t>> order;
    for (size_t i = 0; i < group.examples.size(); ++i) {
        const std::string& scene = group.scene(group.examples[i]);
        order.emplace_back(hash(seed, hashBytes(scene.data(), scene.size()), group.examples[i].viewpoint), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<size_t> chosen;
    for (size_t i = 0; i < std::min(count, order.size()); ++i) chosen.push_back(order[i].second);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

}  // namespace drc
