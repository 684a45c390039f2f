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
#include "image/image_io.h"
#include "image/relmse.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKey = "drc:bench_key";
constexpr const char* kOrigin = "drc:bench_origin";
constexpr const char* kError = "drc:bench_error";
constexpr int kFirstSpp = 64;        // of the first two parts; each later pair has twice as many
constexpr int kFirstSeed = 1 << 20;  // far from the seeds of the runs that are compared

std::string entry(const ExrMetadata& metadata, const char* name) {
    const auto found = metadata.find(name);
    return found == metadata.end() ? "" : found->second;
}

// Of a file of ours with this key.
std::optional<ExrMetadata> metadataOf(const fs::path& path, const std::string& key) {
    if (!fs::exists(path)) return {};
    try {
        ExrMetadata metadata = readExrMetadata(path.string());
        if (entry(metadata, kKey) == key) return metadata;
    } catch (const Error&) {  // damaged: as if it were not there
    }
    return {};
}

struct Half {
    Image sum;
    double spp = 0;

    void add(const Image& picture, double samples) {
        if (sum.empty()) sum = Image(picture.width(), picture.height());
        for (size_t i = 0; i < sum.data().size(); ++i) sum.data()[i] += float(samples) * picture.data()[i];
        spp += samples;
    }
    Image mean() const {
        Image m = sum;
        for (float& x : m.data()) x /= float(spp);
        return m;
    }
};

}  // namespace

Reference renderReference(const std::string& scene, const std::string& name, int width, int height,
                          const std::string& folder, const std::string& key, const ReferenceSettings& settings,
                          const CancelToken* cancel) {
    const std::string size = fmt::format("{}x{}", width, height);
    const fs::path target = fs::path(folder) / fmt::format("{}-{}.exr", name, size);
    const std::string wholeKey = settings.integrator + "\n" + key;
    if (const auto metadata = metadataOf(target, wholeKey))
        if (std::strtod(entry(*metadata, kError).c_str(), nullptr) <= settings.error)
            return {target.string(), entry(*metadata, kOrigin)};

    const fs::path parts = fs::path(folder) / fmt::format("{}-{}-parts", name, size);
    fs::create_directories(parts);
    Half halves[2];
    double error = kInfinity;
    for (int part = 0; error > settings.error || part % 2; ++part) {
        const int spp = kFirstSpp << std::min(part / 2, 20);
        if (part % 2 == 0 && halves[0].spp + halves[1].spp + 2 * spp > settings.maxSpp) break;
        const fs::path file = parts / fmt::format("{:02}.exr", part);
        if (!metadataOf(file, wholeKey)) {
            logInfo(fmt::format("reference of {}: {:g} spp so far{}, {} more", name, halves[0].spp + halves[1].spp,
                                std::isfinite(error) ? fmt::format(", relMSE about {:.1e}", error) : "", spp));
            const std::string raw = (parts / "part.exr").string();
            const ProcessUse use =
                runMeasured({settings.program, "render", scene, "--integrator", settings.integrator, "--spp",
                             std::to_string(spp), "--seed", std::to_string(kFirstSeed + part), "--resolution", size,
                             "--nthreads", std::to_string(settings.threads), "--quiet", "-o", raw},
                            {}, cancel);
            if (cancel && cancel->cancelled()) return {};
            if (use.exitCode != 0)
                throw Error(fmt::format("the reference of {} could not be rendered: {}", name, lastLine(use.output)));
            writeExr(file.string(), readLinearRgb(raw), {{kKey, wholeKey}});
            fs::remove(raw);
        }
        halves[part % 2].add(readLinearRgb(file.string()), spp);
        if (part % 2) error = radianceErrors(halves[0].mean(), halves[1].mean()).relmse / 4;
    }
    if (halves[1].spp == 0)
        throw Error(fmt::format("the reference of {}: at least {} spp are needed", name, 2 * kFirstSpp));
    if (error > settings.error)
        logWarning(fmt::format("the reference of {} has a relMSE of about {:.1e} after {:g} spp; {:.1e} was wanted",
                               name, error, halves[0].spp + halves[1].spp, settings.error));
    Half whole;
    for (const Half& half : halves) whole.add(half.mean(), half.spp);
    const std::string origin = fmt::format("{}, {:g} spp, relMSE about {:.1e}", settings.integrator, whole.spp, error);
    writeExr(target.string(), whole.mean(),
             {{kKey, wholeKey}, {kOrigin, origin}, {kError, fmt::format("{:.6e}", error)}});
    fs::remove_all(parts);
    return {target.string(), origin};
}

}  // namespace drc
