// The typed parameters of one directive, with their positions in the file.
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
    // Exactly one of these contains the values, depending on `type`: numbers for floats, integers, points, vectors and
    // normals (as consecutive components), strings for strings and textures.
    std::vector<double> numbers;
    std::vector<std::string> strings;
    std::vector<bool> bools;
    std::vector<Rgb> colors;  // rgb, xyz, blackbody and spectrum, converted to linear RGB
    bool inherited = false;   // set by pbrt-v4's Attribute, so perhaps meant for other directives
    mutable bool used = false;

    // The number of values of `type`: for points, the number of points, not of coordinates.
    size_t count() const;
    // Whether this is a texture with the empty name. All getters treat it as missing.
    bool namesNoTexture() const;
};

// Each getter marks the parameter as used, and returns the fallback if it is missing. A parameter of the wrong type
// counts as missing, with a warning, as in pbrt-v3. Throws Error at a parameter that does not have exactly one value.
class ParamSet {
  public:
    ParamSet() = default;
    // owner is used in messages: "material 'matte'".
    ParamSet(std::string owner, const SourcePos& pos) : owner_(std::move(owner)), pos_(pos) {}

    // Adds a parameter. One of the same name and type is replaced with a warning, as in pbrt.
    void add(Param param);
    // Adds a parameter in place of all parameters of its name, whatever their type.
    void replace(Param param);
    // A copy with only the parameters of these names.
    ParamSet only(std::initializer_list<std::string_view> names) const;
    // Adds those defaults whose names the set does not contain. Unused ones cause no warning.
    void inherit(const ParamSet& defaults);

    float getFloat(std::string_view name, float fallback) const;
    // Throw Error at the parameter if its value is below the bound or NaN. The fallback must satisfy the bound.
    float getPositiveFloat(std::string_view name, float fallback) const;
    float getNonNegativeFloat(std::string_view name, float fallback) const;
    int getInt(std::string_view name, int fallback) const;
    bool getBool(std::string_view name, bool fallback) const;
    std::string getString(std::string_view name, const std::string& fallback) const;
    Vec3 getPoint(std::string_view name, const Vec3& fallback) const;
    Vec3 getVector(std::string_view name, const Vec3& fallback) const;
    Rgb getColor(std::string_view name, const Rgb& fallback) const;

    // The parameter, with any number of values; null if it is missing, or, with a warning, if it has none of these
    // types.
    const Param* find(std::string_view name, std::initializer_list<ParamType> types) const;
    // Like find(), but without the warning: a parameter of another type may be meant for something else.
    const Param* findIfTyped(std::string_view name, std::initializer_list<ParamType> types) const;
    // The string parameter that names a file; null if it is missing or empty.
    const Param* findFile(std::string_view name) const;
    // Like findFile(), but throws Error if the parameter is missing or empty.
    const Param& needFile(std::string_view name) const;
    bool has(std::string_view name) const;

    // The parameters that have been looked up, whether present or not: these are the names that the directive knows.
    struct Known {
        std::map<std::string, std::optional<ParamType>, std::less<>> types;  // no type: accepted without effect
        bool anything = false;                                               // ignoreAll() was called
    };
    // From now on, records look-ups in `known`.
    void noteLookups(Known& known) { known_ = &known; }

    // Accepts these parameters, which have no effect.
    void ignore(std::initializer_list<std::string_view> names) const;
    // Accepts these parameters and warns that they are not supported yet; once per parameter, however many objects have
    // it.
    void notBuilt(std::initializer_list<std::string_view> names) const;
    // Accepts all parameters, for directives that are not supported.
    void ignoreAll() const;
    // Warns about each parameter that was never read; once per parameter, however many objects have it.
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

// The type with the name "float", "rgb", "point3", ...; none for any other name.
std::optional<ParamType> paramTypeNamed(std::string_view typeName);
// The type as written in a scene file, for messages.
std::string describe(ParamType type);
// Number of components per value; 1 for types that are not numeric.
size_t componentsOf(ParamType type);

Vec2 vec2At(const std::vector<double>& numbers, size_t index);
Vec3 vec3At(const std::vector<double>& numbers, size_t index);
// Whether a parameter of type 'integer' may have this value: a whole number from -2^31 to 2^31 - 1.
bool isInteger(double number);

}  // namespace drc::pbrt
