#include "pbrt/param_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/limits.h"

namespace drc::pbrt {
namespace {

struct TypeName {
    std::string_view name;
    ParamType type;
};
constexpr TypeName kTypeNames[] = {
    {"float", ParamType::Float},     {"integer", ParamType::Integer}, {"bool", ParamType::Bool},
    {"string", ParamType::String},   {"point2", ParamType::Point2},   {"vector2", ParamType::Vector2},
    {"point3", ParamType::Point3},   {"point", ParamType::Point3},    {"vector3", ParamType::Vector3},
    {"vector", ParamType::Vector3},  {"normal3", ParamType::Normal3}, {"normal", ParamType::Normal3},
    {"rgb", ParamType::Color},       {"color", ParamType::Color},     {"xyz", ParamType::Color},
    {"blackbody", ParamType::Color}, {"spectrum", ParamType::Color},  {"texture", ParamType::Texture},
};

bool isIn(ParamType type, std::initializer_list<ParamType> types) {
    return std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

std::optional<ParamType> paramTypeNamed(std::string_view typeName) {
    for (const TypeName& entry : kTypeNames)
        if (entry.name == typeName) return entry.type;
    return std::nullopt;
}

std::string describe(ParamType type) {
    if (type == ParamType::Color) return "'rgb' (or 'xyz', 'blackbody', 'spectrum')";
    for (const TypeName& entry : kTypeNames)
        if (entry.type == type) return "'" + std::string(entry.name) + "'";
    return "";
}

size_t componentsOf(ParamType type) {
    switch (type) {
        case ParamType::Point2:
        case ParamType::Vector2:
            return 2;
        case ParamType::Point3:
        case ParamType::Vector3:
        case ParamType::Normal3:
            return 3;
        default:
            return 1;
    }
}

Vec2 vec2At(const std::vector<double>& n, size_t i) { return Vec2(float(n[2 * i]), float(n[2 * i + 1])); }
Vec3 vec3At(const std::vector<double>& n, size_t i) {
    return Vec3(float(n[3 * i]), float(n[3 * i + 1]), float(n[3 * i + 2]));
}

size_t Param::count() const {
    switch (type) {
        case ParamType::Bool:
            return bools.size();
        case ParamType::Color:
            return colors.size();
        case ParamType::String:
        case ParamType::Texture:
            return strings.size();
        default:
            return numbers.size() / componentsOf(type);
    }
}

bool Param::namesNoTexture() const { return type == ParamType::Texture && count() == 1 && strings[0].empty(); }

void ParamSet::add(Param param) {
    for (Param& old : params_)
        if (old.name == param.name && old.type == param.type) {
            warn(param.pos, "parameter '" + param.name + "' of " + owner_ + " is given twice; the last one counts");
            old = std::move(param);
            return;
        }
    if (params_.size() >= limits::kParameters)
        failAt(param, "is one too many: there may be " + std::to_string(limits::kParameters));
    params_.push_back(std::move(param));
}

void ParamSet::replace(Param param) {
    std::erase_if(params_, [&](const Param& old) { return old.name == param.name; });
    add(std::move(param));
}

void ParamSet::note(std::string_view name, std::optional<ParamType> type) const {
    if (known_ == nullptr) return;
    auto& known = known_->types[std::string(name)];
    if (!known) known = type;
}

void ParamSet::inherit(const ParamSet& defaults) {
    const size_t own = params_.size();
    for (const Param& param : defaults.params_) {
        if (std::any_of(params_.begin(), params_.begin() + std::ptrdiff_t(own),
                        [&](const Param& p) { return p.name == param.name; }))
            continue;
        params_.push_back(param);
        params_.back().inherited = true;
        params_.back().used = false;
    }
}

ParamSet ParamSet::only(std::initializer_list<std::string_view> names) const {
    ParamSet part(owner_, pos_);
    for (const Param& param : params_)
        if (std::find(names.begin(), names.end(), param.name) != names.end()) part.params_.push_back(param);
    return part;
}

void ParamSet::failAt(const Param& param, const std::string& complaint) const {
    fail(param.pos, "parameter '" + param.name + "' of " + owner_ + " " + complaint);
}

bool ParamSet::has(std::string_view name) const {
    note(name, std::nullopt);
    return std::any_of(params_.begin(), params_.end(), [&](const Param& p) { return p.name == name; });
}

const Param* ParamSet::findIfTyped(std::string_view name, std::initializer_list<ParamType> types) const {
    note(name, *types.begin());
    for (const Param& param : params_)
        if (param.name == name && isIn(param.type, types)) {
            param.used = true;
            if (!param.namesNoTexture()) return &param;
        }
    return nullptr;
}

const Param* ParamSet::find(std::string_view name, std::initializer_list<ParamType> types) const {
    if (const Param* found = findIfTyped(name, types)) return found;
    for (const Param& param : params_) {
        // Another look-up may have used the parameter under its own type, for example "texture Kd" beside "rgb Kd".
        if (param.name != name || param.used) continue;
        param.used = true;
        if (param.inherited) continue;  // it may be meant for other directives
        std::string expected;
        for (const ParamType type : types) expected += (expected.empty() ? "" : " or ") + describe(type);
        warnOnce(param.pos, "parameter '" + param.name + "' of " + owner_ + " must be of type " + expected + ", not '" +
                                param.typeName + "'; ignored");
    }
    return nullptr;
}

const Param* ParamSet::findFile(std::string_view name) const {
    const Param* file = findOne(name, ParamType::String);
    return file != nullptr && !file->strings[0].empty() ? file : nullptr;
}

const Param& ParamSet::needFile(std::string_view name) const {
    if (const Param* file = findFile(name)) return *file;
    if (const Param* empty = findIfTyped(name, {ParamType::String})) failAt(*empty, "is empty; it must name a file");
    fail(pos_, owner_ + " needs the parameter \"string " + std::string(name) + "\"");
}

bool isInteger(double number) {
    return number == std::trunc(number) && number >= std::numeric_limits<int>::min() &&
           number <= std::numeric_limits<int>::max();
}

const Param* ParamSet::findOne(std::string_view name, ParamType type) const {
    const Param* param = find(name, {type});
    if (param != nullptr && param->count() != 1)
        failAt(*param, "must have one value of type " + describe(type) + ", not " + std::to_string(param->count()));
    return param;
}

float ParamSet::getFloat(std::string_view name, float fallback) const {
    const Param* param = findOne(name, ParamType::Float);
    return param != nullptr ? float(param->numbers[0]) : fallback;
}

float ParamSet::getPositiveFloat(std::string_view name, float fallback) const {
    const Param* param = findOne(name, ParamType::Float);
    if (param == nullptr) return fallback;
    const float value = float(param->numbers[0]);
    if (!(value > 0)) failAt(*param, "must be positive");
    return value;
}

float ParamSet::getNonNegativeFloat(std::string_view name, float fallback) const {
    const Param* param = findOne(name, ParamType::Float);
    if (param == nullptr) return fallback;
    const float value = float(param->numbers[0]);
    if (!(value >= 0)) failAt(*param, "must not be negative");
    return value;
}

int ParamSet::getInt(std::string_view name, int fallback) const {
    const Param* param = findOne(name, ParamType::Integer);
    return param != nullptr ? int(param->numbers[0]) : fallback;
}

bool ParamSet::getBool(std::string_view name, bool fallback) const {
    const Param* param = findOne(name, ParamType::Bool);
    return param != nullptr ? bool(param->bools[0]) : fallback;
}

std::string ParamSet::getString(std::string_view name, const std::string& fallback) const {
    const Param* param = findOne(name, ParamType::String);
    return param != nullptr ? param->strings[0] : fallback;
}

Vec3 ParamSet::getPoint(std::string_view name, const Vec3& fallback) const {
    const Param* param = findOne(name, ParamType::Point3);
    return param != nullptr ? vec3At(param->numbers, 0) : fallback;
}

Vec3 ParamSet::getVector(std::string_view name, const Vec3& fallback) const {
    const Param* param = findOne(name, ParamType::Vector3);
    return param != nullptr ? vec3At(param->numbers, 0) : fallback;
}

Rgb ParamSet::getColor(std::string_view name, const Rgb& fallback) const {
    const Param* param = findOne(name, ParamType::Color);
    return param != nullptr ? param->colors[0] : fallback;
}

void ParamSet::ignore(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names) note(name, std::nullopt);
    for (const Param& param : params_)
        if (std::find(names.begin(), names.end(), param.name) != names.end()) param.used = true;
}

void ParamSet::notBuilt(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names) note(name, std::nullopt);
    for (const Param& param : params_) {
        if (param.used || std::find(names.begin(), names.end(), param.name) == names.end()) continue;
        param.used = true;
        warnOnce(param.pos, "parameter '" + param.name + "' of " + owner_ + " is not supported yet; ignored");
    }
}

void ParamSet::ignoreAll() const {
    if (known_ != nullptr) known_->anything = true;
    for (const Param& param : params_) param.used = true;
}

size_t ParamSet::unusedCount() const {
    return size_t(std::count_if(params_.begin(), params_.end(), [](const Param& p) { return !p.used; }));
}

void ParamSet::warnUnused() const {
    for (const Param& param : params_) {
        if (param.used || param.inherited) continue;
        param.used = true;  // only one warning, however often the set is used
        warnOnce(param.pos, "unknown parameter '" + param.name + "' of " + owner_ + "; ignored");
    }
}

}  // namespace drc::pbrt
