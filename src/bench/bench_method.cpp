#include "bench/bench_method.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "base/error.h"
#include "integrators/integrator.h"

namespace drc {
namespace {

constexpr std::array kMapDenoisers{"none", "gaussian", "oracle"};
constexpr std::array kDenoisers{"off", "surface", "oidn", "oidn-direct"};

template <typename List>
bool isOneOf(const std::string& name, const List& list) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> found;
    for (std::string word; in >> word;) found.push_back(word);
    return found;
}

// The last --integrator among options; the default one if there is none.
std::string integratorAmong(const std::vector<std::string>& options) {
    constexpr std::string_view kOption = "--integrator";
    std::string integrator = RenderParams().integrator;
    for (size_t i = 0; i < options.size(); ++i) {
        if (options[i] == kOption && i + 1 < options.size()) integrator = options[i + 1];
        if (options[i].starts_with(std::string(kOption) + "=")) integrator = options[i].substr(kOption.size() + 1);
    }
    return integrator;
}

}  // namespace

BenchMethod::BenchMethod(const std::string& text,
                         const std::function<std::optional<Adapter>(const std::string&)>& findAdapter) {
    const size_t equals = text.find('=');
    if (equals != std::string::npos) {
        name_ = text.substr(0, equals);
        options_ = words(text.substr(equals + 1));
        if (name_.empty()) throw Error(fmt::format("method '{}': has no name before the =", text));
        const std::string integrator = integratorAmong(options_);
        hasMaps_ = integrator != "scene" && traitsOf(integrator).maps;
        return;
    }
    name_ = text;
    const size_t plus = text.find('+');
    if (plus != std::string::npos) denoiser_ = text.substr(plus + 1);
    const std::string way = text.substr(0, plus);
    const size_t colon = way.find(':');
    const std::string integrator = way.substr(0, colon);
    const std::vector<std::string> integrators = integratorNames();
    if (!isOneOf(integrator, integrators)) {
        if (colon == std::string::npos) adapter_ = findAdapter(way);
        if (!adapter_)
            throw Error(fmt::format(
                "method '{}': there are {}, drc-maps:MAP-DENOISER, drc-maps:NETWORK, NAME=OPTIONS, and what "
                "--adapter names",
                text, fmt::join(integrators, ", ")));
        if (plus != std::string::npos && !adapter_->denoises(denoiser_))
            throw Error(fmt::format("method '{}': {} does not denoise by '{}'", text, way, denoiser_));
        return;
    }
    hasMaps_ = traitsOf(integrator).maps;
    options_ = {"--integrator", integrator};
    if (colon != std::string::npos) {
        const std::string mapDenoiser = way.substr(colon + 1);
        if (!hasMaps_ || mapDenoiser.empty())
            throw Error(fmt::format(
                "method '{}': only drc-maps takes a map denoiser or a network, as drc-maps:gaussian", text));
        options_.insert(options_.end(),
                        {isOneOf(mapDenoiser, kMapDenoisers) ? "--map-denoiser" : "--weights", mapDenoiser});
    }
    if (plus == std::string::npos) {
        // drc is what a user of it gets; the others are there to be compared with, and only with +DENOISER denoised.
        if (integrator != "drc" && !hasMaps_) options_.insert(options_.end(), {"--denoise", "off"});
        return;
    }
    if (const size_t mode = denoiser_.find(':'); mode != std::string::npos) {
        oidnMode_ = findOidnMode(denoiser_.substr(mode + 1));
        denoiser_.resize(mode);
        if (!oidnMode_ || !denoiser_.starts_with("oidn")) {
            std::string modes;
            for (const OidnMode& known : oidnModes()) modes += std::string(modes.empty() ? "" : ", ") + known.name;
            throw Error(fmt::format("method '{}': oidn and oidn-direct have the modes {}", text, modes));
        }
    }
    if (!isOneOf(denoiser_, kDenoisers))
        throw Error(fmt::format("method '{}': denoisers are off, surface, oidn and oidn-direct", text));
    if (!hasMaps_ && (denoiser_ == "surface" || denoiser_ == "oidn-direct"))
        throw Error(fmt::format("method '{}': {} filters the layers that only drc-maps has", text, denoiser_));
    options_.insert(options_.end(), {"--denoise", denoiser_});
}

bool BenchMethod::keeps(BudgetUnit unit) const {
    if (adapter_) return adapter_->commands.contains(unit);
    return unit == BudgetUnit::Seconds || (unit == BudgetUnit::Tasks) == hasMaps_;
}

const OidnMode* BenchMethod::oidnMode(const BenchJob& job) const {
    if (adapter_ || !denoiser_.starts_with("oidn")) return nullptr;
    if (oidnMode_) return oidnMode_;
    // Samples and tasks cost no time that denoising could take.
    const bool timed = job.budget.unit == BudgetUnit::Seconds;
    return &bestOidnMode(timed ? job.budget.amount : INFINITY, double(job.width) * job.height, job.threads);
}

std::vector<std::string> BenchMethod::command(const BenchJob& job, const OwnProgram& own) const {
    if (adapter_) {
        AdapterValues values;
        values.scene = job.scene, values.output = job.output, values.timing = job.timing;
        values.width = job.width, values.height = job.height;
        values.threads = job.threads, values.seed = job.seed;
        values.denoiser = denoiser_, values.amount = job.budget.amount;
        return adapter_->command(job.budget.unit, values).value();
    }
    std::vector<std::string> argv{own.path, "render", job.scene};
    argv.insert(argv.end(), options_.begin(), options_.end());
    if (!own.oidnLibrary.empty() && denoiser_.starts_with("oidn"))
        argv.insert(argv.end(), {"--oidn-library", own.oidnLibrary});
    if (const OidnMode* mode = oidnMode(job))
        argv.insert(argv.end(), {"--oidn-quality", mode->quality, "--oidn-prefilter", mode->prefilter ? "on" : "off"});
    const std::string amount = fmt::format("{:g}", job.budget.amount);
    if (job.budget.unit == BudgetUnit::Seconds) argv.insert(argv.end(), {"--time", amount});
    if (job.budget.unit == BudgetUnit::Spp) argv.insert(argv.end(), {"--spp", amount});
    if (job.budget.unit == BudgetUnit::Tasks)
        argv.insert(argv.end(), {"--indirect-tasks", amount, "--spp", std::to_string(own.directSpp)});
    argv.insert(argv.end(),
                {"--resolution", fmt::format("{}x{}", job.width, job.height), "--nthreads", std::to_string(job.threads),
                 "--seed", std::to_string(job.seed), "--timing", job.timing, "--quiet", "-o", job.output});
    return argv;
}

}  // namespace drc
