#include "bench/adapter.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/error.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Unit {
    const char* name;
    BudgetUnit unit;
};
constexpr Unit kUnits[] = {{"seconds", BudgetUnit::Seconds}, {"spp", BudgetUnit::Spp}};
constexpr std::array kKeys{"name", "about", "check", "install", "denoisers", "command"};
constexpr std::array kPlaceholders{"folder",  "scene",   "output", "width",    "height", "seed",
                                   "threads", "seconds", "spp",    "denoiser", "timing"};

// Replaces {name} by what `value` gives for the name; "{{" and "}}" are braces.
template <typename Value>
std::string expand(const std::string& text, const Value& value) {
    std::string expanded;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if ((c == '{' || c == '}') && i + 1 < text.size() && text[i + 1] == c) {
            expanded += c;
            ++i;
        } else if (c == '{') {
            const size_t end = text.find('}', i);
            if (end == std::string::npos) throw Error(fmt::format("'{}': a brace is not closed", text));
            expanded += value(text.substr(i + 1, end - i - 1));
            i = end;
        } else if (c == '}') {
            throw Error(fmt::format("'{}': a brace is closed that was not opened; write }}}} for one", text));
        } else {
            expanded += c;
        }
    }
    return expanded;
}

void checkPlaceholders(const std::string& text, BudgetUnit unit) {
    expand(text, [&](const std::string& name) -> std::string {
        if (std::find(kPlaceholders.begin(), kPlaceholders.end(), name) == kPlaceholders.end())
            throw Error(
                fmt::format("'{}': no placeholder {{{}}}; there are {}", text, name, fmt::join(kPlaceholders, ", ")));
        for (const Unit& other : kUnits)
            if (name == other.name && unit != other.unit)
                throw Error(fmt::format("'{}': {{{}}} has no value where the budget is another", text, name));
        return "";
    });
}

std::vector<std::string> strings(const Json& json, const std::string& key) {
    const auto wrong = [&] { return Error(fmt::format("\"{}\" must be a list of strings", key)); };
    if (!json.is_array()) throw wrong();
    std::vector<std::string> list;
    for (const Json& item : json) {
        if (!item.is_string()) throw wrong();
        list.push_back(item.get<std::string>());
    }
    return list;
}

std::string text(const Json& json, const std::string& key) {
    const auto found = json.find(key);
    if (found == json.end()) throw Error(fmt::format("\"{}\" is missing", key));
    if (!found->is_string() || found->get<std::string>().empty())
        throw Error(fmt::format("\"{}\" must be a text that is not empty", key));
    return found->get<std::string>();
}

Adapter fromJson(const Json& json) {
    if (!json.is_object()) throw Error("an adapter is a JSON object");
    for (const auto& [key, value] : json.items())
        if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end())
            throw Error(fmt::format("unknown key \"{}\"; there are {}", key, fmt::join(kKeys, ", ")));
    Adapter adapter;
    adapter.name = text(json, "name");
    if (adapter.name.find_first_of("+:=,/ ") != std::string::npos)
        throw Error(fmt::format("\"name\": '{}' may have none of +:=,/ and no blanks", adapter.name));
    adapter.about = text(json, "about");
    adapter.install = text(json, "install");
    if (json.contains("check")) adapter.check = strings(json["check"], "check");
    if (json.contains("denoisers")) adapter.denoisers = strings(json["denoisers"], "denoisers");
    const auto commands = json.find("command");
    if (commands == json.end() || !commands->is_object() || commands->empty())
        throw Error("\"command\" must be an object with \"seconds\", \"spp\" or both");
    for (const auto& [key, value] : commands->items()) {
        const auto unit =
            std::find_if(std::begin(kUnits), std::end(kUnits), [&](const Unit& u) { return key == u.name; });
        if (unit == std::end(kUnits))
            throw Error(fmt::format("\"command\": unknown unit \"{}\"; there are seconds and spp", key));
        const std::vector<std::string> argv = strings(value, key);
        if (argv.empty()) throw Error(fmt::format("\"{}\" has no program", key));
        for (const std::string& argument : argv) checkPlaceholders(argument, unit->unit);
        adapter.commands[unit->unit] = argv;
    }
    return adapter;
}

}  // namespace

bool Adapter::denoises(const std::string& denoiser) const {
    return std::find(denoisers.begin(), denoisers.end(), denoiser) != denoisers.end();
}

std::optional<std::vector<std::string>> Adapter::command(BudgetUnit unit, const AdapterValues& values) const {
    const auto found = commands.find(unit);
    if (found == commands.end()) return {};
    const std::map<std::string, std::string> byName{{"folder", folder},
                                                    {"scene", values.scene},
                                                    {"output", values.output},
                                                    {"width", std::to_string(values.width)},
                                                    {"height", std::to_string(values.height)},
                                                    {"seed", std::to_string(values.seed)},
                                                    {"threads", std::to_string(values.threads)},
                                                    {"seconds", fmt::format("{:g}", values.amount)},
                                                    {"spp", fmt::format("{:g}", values.amount)},
                                                    {"denoiser", values.denoiser.empty() ? "off" : values.denoiser},
                                                    {"timing", values.timing}};
    std::vector<std::string> argv;
    for (const std::string& argument : found->second)
        argv.push_back(expand(argument, [&](const std::string& key) { return byName.at(key); }));
    return argv;
}

Adapter readAdapter(const std::string& path) {
    const fs::path file = fs::is_directory(path) ? fs::path(path) / "adapter.json" : fs::path(path);
    try {
        Adapter adapter = fromJson(Json::parse(readFile(file.string())));
        adapter.folder = fs::absolute(file).parent_path().lexically_normal().string();
        // A folder's path may have braces of its own: it is put in as a value, never expanded.
        for (std::string& argument : adapter.check)
            argument = expand(argument, [&](const std::string& name) {
                if (name != "folder")
                    throw Error(fmt::format("\"check\": only {{folder}} has a value there, not {{{}}}", name));
                return adapter.folder;
            });
        return adapter;
    } catch (const Json::parse_error& error) {
        const std::string what = error.what();
        throw Error(fmt::format("{}: not JSON: {}", file.string(), what.substr(what.find("] ") + 2)));
    } catch (const Error& error) {
        const std::string what = error.what();
        if (what.starts_with(file.string())) throw;
        throw Error(file.string() + ": " + what);
    }
}

}  // namespace drc
