// The typed parameters of one directive, with the places where they were written.
#pragma once
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec.h"
#include "pbrt/source.h"

namespace drc::pbrt {

enum class ParamType { Float, Integer, Bool, String, Point2, Vector2, Point3, Vector3, Normal3, Color, Texture };

struct Param {
    ParamType type = ParamType::Float;
    std::string typeName;  // as written: "point", "rgb", ...
    std::string name;
    SourcePos pos;       // of the declaration
    SourcePos valuePos;  // of the first value
    // Exactly one of these has the values, as `type` says: numbers for floats, integers, points, vectors and normals
    // (their components in a row), strings for strings and textures.
    std::vector<double> numbers;
    std::vector<std::string> strings;
    std::vector<bool> bools;
    std::vector<Rgb> colors;  // rgb, xyz, blackbody and spectrum, converted
    bool inherited = false;   // from pbrt-v4's Attribute: may be meant for others
    mutable bool used = false;

    // Of type's units: points, not coordinates.
    size_t count() const;
};

// Each getter marks the parameter as used, returns the default where there is none, and throws Error, at the
// parameter, if it is there with another type or not with exactly one value.
class ParamSet {
  public:
    ParamSet() = default;
    // owner is for messages: "material 'matte'".
    ParamSet(std::string owner, const SourcePos& pos) : owner_(std::move(owner)), pos_(pos) {}

    // One of the same name and type is replaced, as in pbrt.
    void add(Param param);
    // In place of all of that name, whatever their type.
    void replace(Param param);
    // What the set does not name itself. Nobody need look these up.
    void inherit(const ParamSet& defaults);

    float getFloat(std::string_view name, float fallback) const;
    // Throw Error, at the parameter, for a value below the bound or no number. The fallback must be within it.
    float getPositiveFloat(std::string_view name, float fallback) const;
    float getNonNegativeFloat(std::string_view name, float fallback) const;
    int getInt(std::string_view name, int fallback) const;
    bool getBool(std::string_view name, bool fallback) const;
    std::string getString(std::string_view name, const std::string& fallback) const;
    Vec3 getPoint(std::string_view name, const Vec3& fallback) const;
    Rgb getColor(std::string_view name, const Rgb& fallback) const;

    // Any number of values; null if there is no such parameter. Throws Error if it has none of these types.
    const Param* find(std::string_view name, std::initializer_list<ParamType> types) const;
    // The same, but a parameter of another type counts as none and no error: it is meant for somebody else.
    const Param* findIfTyped(std::string_view name, std::initializer_list<ParamType> types) const;
    bool has(std::string_view name) const;

    // Which parameters were asked for, there or not: what whoever uses the set knows.
    struct Known {
        std::map<std::string, std::optional<ParamType>, std::less<>> types;  // none: accepted without effect
        bool anything = false;                                               // ignoreAll() was called
    };
    // From now on, look-ups are noted there.
    void noteLookups(Known& known) { known_ = &known; }

    // Accepts without effect.
    void ignore(std::initializer_list<std::string_view> names) const;
    // Accepts with the warning that it is not supported yet.
    void notBuilt(std::initializer_list<std::string_view> names) const;
    // Accepts everything, for what is not built as a whole.
    void ignoreAll() const;
    // One warning for each parameter that nobody looked up.
    void warnUnused() const;
    size_t unusedCount() const;

    const std::vector<Param>& all() const { return params_; }
    const std::string& owner() const { return owner_; }
    const SourcePos& pos() const { return pos_; }
    // Throws Error at the parameter: "parameter 'x' of material 'matte' " + complaint.
    [[noreturn]] void failAt(const Param& param, const std::string& complaint) const;

  private:
    const Param* findOne(std::string_view name, ParamType type) const;
    void note(std::string_view name, std::optional<ParamType> type) const;

    std::string owner_;
    SourcePos pos_;
    std::vector<Param> params_;
    Known* known_ = nullptr;
};

// "float", "rgb", "point3", ...; none: no such type.
std::optional<ParamType> paramTypeNamed(std::string_view typeName);
// For messages: what a user writes for this type.
std::string describe(ParamType type);
// Numbers to one value; 1 where values are not numbers.
size_t componentsOf(ParamType type);

Vec2 vec2At(const std::vector<double>& numbers, size_t index);
Vec3 vec3At(const std::vector<double>& numbers, size_t index);

}  // namespace drc::pbrt
