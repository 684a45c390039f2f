#include "bench/bench_reference.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/log.h"
#include "bench/measured_process.h"
#include "image/cross_error.h"
#include "image/image_io.h"
#include "image/relative_norm.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKey = "drc:bench_key";
constexpr const char* kOrigin = "drc:bench_origin";
constexpr const char* kError = "drc:bench_error";
constexpr const char* kSpp = "drc:bench_spp";
constexpr const char* kParts = "drc:bench_parts";
constexpr int kStreams = 4;          // first and second half of the first reference, then of the second
constexpr int kFirstSpp = 32;        // of a stream's first part; each later one adds half of what there is
constexpr int kFirstSeed = 1 << 20;  // far from the seeds of the runs that are compared

std::string entry(const ExrMetadata& metadata, const char* name) {
    const auto found = metadata.find(name);
    return found == metadata.end() ? "" : found->second;
}

// Metadata of a file that we wrote with this key; none if there is no such file.
std::optional<ExrMetadata> metadataOf(const fs::path& path, const std::string& key) {
    if (!fs::exists(path)) return {};
    try {
        ExrMetadata metadata = readExrMetadata(path.string());
        if (entry(metadata, kKey) == key) return metadata;
    } catch (const Error&) {  // damaged: as if it were not there
    }
    return {};
}

Image weightedMean(const Image& a, double weightA, const Image& b, double weightB) {
    Image mean = a;
    for (size_t i = 0; i < mean.data().size(); ++i)
        mean.data()[i] = float((weightA * a.data()[i] + weightB * b.data()[i]) / (weightA + weightB));
    return mean;
}

// The mean of parts of different seeds; a file that is replaced as it grows.
struct Stream {
    Stream(const fs::path& file, const std::string& key) : path(file) {
        const auto metadata = metadataOf(path, key);
        if (!metadata) return;
        mean = readLinearRgb(path.string());
        spp = std::atoi(entry(*metadata, kSpp).c_str());
        parts = std::atoi(entry(*metadata, kParts).c_str());
    }
    int nextSpp() const { return spp == 0 ? kFirstSpp : spp / 2; }
    void add(const Image& part, const std::string& key) {
        const int samples = nextSpp();
        mean = spp == 0 ? part : weightedMean(mean, spp, part, samples);
        spp += samples;
        ++parts;
        writeExr(path.string(), mean, {{kKey, key}, {kSpp, std::to_string(spp)}, {kParts, std::to_string(parts)}});
    }

    fs::path path;
    Image mean;
    int spp = 0, parts = 0;
};

struct State {
    double error = std::numeric_limits<double>::infinity(), noise = 0;
};

State stateOf(const std::vector<Stream>& streams) {
    const Image first = weightedMean(streams[0].mean, 1, streams[1].mean, 1),
                second = weightedMean(streams[2].mean, 1, streams[3].mean, 1), norm = relativeNorm(first, second);
    Plane products = relativeProducts(streams[0].mean, streams[1].mean, streams[2].mean, streams[3].mean, norm);
    for (float& product : products.values) product /= 4;
    return {standardErrorOfZero(products, tileSide(first.width(), first.height())),
            referenceNoise(first, second, norm)};
}

}  // namespace

RenderedReferences renderReferences(const std::string& scene, const std::string& name, int width, int height,
                                    const std::string& folder, const std::string& key,
                                    const ReferenceSettings& settings, const CancelToken* cancel) {
    const std::string size = fmt::format("{}x{}", width, height), stem = fmt::format("{}-{}", name, size);
    const std::string wholeKey = settings.integrator + "\n" + key;
    const fs::path first = fs::path(folder) / (stem + "-1.exr"), second = fs::path(folder) / (stem + "-2.exr");
    const auto knownFirst = metadataOf(first, wholeKey), knownSecond = metadataOf(second, wholeKey);
    if (knownFirst && knownSecond && entry(*knownFirst, kOrigin) == entry(*knownSecond, kOrigin) &&
        std::strtod(entry(*knownFirst, kError).c_str(), nullptr) <= settings.error)
        return {first.string(), second.string(), entry(*knownFirst, kOrigin)};

    const fs::path parts = fs::path(folder) / stem;
    fs::create_directories(parts);
    std::vector<Stream> streams;
    for (const char* file : {"1a.exr", "1b.exr", "2a.exr", "2b.exr"}) streams.emplace_back(parts / file, wholeKey);
    const auto fewest = [&] {
        return std::min_element(streams.begin(), streams.end(),
                                [](const auto& a, const auto& b) { return a.parts < b.parts; });
    };
    const auto complete = [&] {
        return streams[0].parts > 0 &&
               std::all_of(streams.begin(), streams.end(), [&](const auto& s) { return s.parts == streams[0].parts; });
    };
    State state;
    for (;;) {
        if (complete()) {
            state = stateOf(streams);
            if (state.error <= settings.error) break;
            if (2 * (streams[0].spp + streams[0].nextSpp()) > settings.maxSpp) break;
        }
        const auto stream = fewest();
        if (stream->parts == 0 && 2 * kFirstSpp > settings.maxSpp)
            throw Error(fmt::format("the references of {}: at least {} spp are needed", name, 2 * kFirstSpp));
        if (complete())
            logInfo(fmt::format("references of {}: 2 x {} spp so far{}", name, 2 * streams[0].spp,
                                fmt::format(", noise {:.1e}, standard error about {:.1e}", state.noise, state.error)));
        const std::string raw = (parts / "part.exr").string();
        logInfo(fmt::format("references of {}: rendering {} spp, picture {} of {}", name, stream->nextSpp(),
                            int(stream - streams.begin()) + 1, kStreams));
        const int seed = kFirstSeed + kStreams * stream->parts + int(stream - streams.begin());
        const ProcessUse use =
            runMeasured({settings.program, "render", scene, "--integrator", settings.integrator, "--spp",
                         std::to_string(stream->nextSpp()), "--seed", std::to_string(seed), "--resolution", size,
                         "--nthreads", std::to_string(settings.threads), "--denoise", "off", "--quiet", "-o", raw},
                        {}, cancel);
        if (cancel && cancel->cancelled()) return {};
        if (use.exitCode != 0)
            throw Error(fmt::format("the references of {} could not be rendered: {}", name, lastLine(use.output)));
        stream->add(readLinearRgb(raw), wholeKey);
        fs::remove(raw);
    }
    const int spp = 2 * streams[0].spp;
    if (!(state.error <= settings.error))
        logWarning(
            fmt::format("the references of {} leave a standard error of about {:.1e} after 2 x {} spp; {:.1e} "
                        "was wanted",
                        name, state.error, spp, settings.error));
    const std::string origin = fmt::format("{}, 2 x {} spp, noise {:.1e}, standard error about {:.1e}",
                                           settings.integrator, spp, state.noise, state.error);
    const ExrMetadata metadata{{kKey, wholeKey}, {kOrigin, origin}, {kError, fmt::format("{:.6e}", state.error)}};
    writeExr(first.string(), weightedMean(streams[0].mean, 1, streams[1].mean, 1), metadata);
    writeExr(second.string(), weightedMean(streams[2].mean, 1, streams[3].mean, 1), metadata);
    return {first.string(), second.string(), origin};
}

}  // namespace drc
