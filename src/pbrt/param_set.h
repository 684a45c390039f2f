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
    // Exactly one of these has the values, depending on `type`: numbers for floats, integers, points, vectors and
    // normals (as consecutive components), strings for strings and textures.
    std::vector<double> numbers;
    std::vector<std::string> strings;
    std::vector<bool> bools;
    std::vector<Rgb> colors;  // rgb, xyz, blackbody and spectrum, converted
    bool inherited = false;   // from pbrt-v4's Attribute, which may be meant for other directives
    mutable bool used = false;

    // The number of values of `type`: points, not their coordinates.
    size_t count() const;
    // Whether it is a texture with the empty name. To all getters it is as if it were not given.
    bool namesNoTexture() const;
};

// Each getter marks the parameter as used, and returns the default if there is none. A parameter of another type is
// none, with a warning, as in pbrt-v3. Throws Error at a parameter that does not have exactly one value.
class ParamSet {
  public:
    ParamSet() = default;
    // owner is used in messages: "material 'matte'".
    ParamSet(std::string owner, const SourcePos& pos) : owner_(std::move(owner)), pos_(pos) {}

    // Replaces a parameter of the same name and type, as in pbrt.
    void add(Param param);
    // Replaces all parameters of that name, whatever their type.
    void replace(Param param);
    // A set of these parameters alone, as far as there are any.
    ParamSet only(std::initializer_list<std::string_view> names) const;
    // Adds the defaults that the set does not have itself. Unused ones give no warning.
    void inherit(const ParamSet& defaults);

    float getFloat(std::string_view name, float fallback) const;
    // Throw Error at the parameter for values below the bound or NaN. The fallback must satisfy the bound.
    float getPositiveFloat(std::string_view name, float fallback) const;
    float getNonNegativeFloat(std::string_view name, float fallback) const;
    int getInt(std::string_view name, int fallback) const;
    bool getBool(std::string_view name, bool fallback) const;
    std::string getString(std::string_view name, const std::string& fallback) const;
    Vec3 getPoint(std::string_view name, const Vec3& fallback) const;
    Vec3 getVector(std::string_view name, const Vec3& fallback) const;
    Rgb getColor(std::string_view name, const Rgb& fallback) const;

    // Any number of values; null if there is no such parameter, and with a warning if it has none of these types.
    const Param* find(std::string_view name, std::initializer_list<ParamType> types) const;
    // Like find(), but without a warning: a parameter of another type may be meant for something else.
    const Param* findIfTyped(std::string_view name, std::initializer_list<ParamType> types) const;
    // The string that names a file; null if there is none, or if it is empty, which names none.
    const Param* findFile(std::string_view name) const;
    // Like findFile(), but throws Error if there is none.
    const Param& needFile(std::string_view name) const;
    bool has(std::string_view name) const;

    // Which parameters have been looked up, whether they are there or not: the names that the directive knows.
    struct Known {
        std::map<std::string, std::optional<ParamType>, std::less<>> types;  // none: accepted without effect
        bool anything = false;                                               // ignoreAll() was called
    };
    // From now on, look-ups are noted there.
    void noteLookups(Known& known) { known_ = &known; }

    // Accepts these parameters, which have no effect.
    void ignore(std::initializer_list<std::string_view> names) const;
    // Accepts these parameters, with one warning for each and all of their owners that it is not supported yet.
    void notBuilt(std::initializer_list<std::string_view> names) const;
    // Accepts all parameters, for directives that are not supported.
    void ignoreAll() const;
    // Warns of each parameter that was never read; of the same one of many shapes only once.
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

// The type named "float", "rgb", "point3", ...; none for any other name.
std::optional<ParamType> paramTypeNamed(std::string_view typeName);
// The type as a user writes it, for messages.
std::string describe(ParamType type);
// Numbers per value; 1 for types that are not numeric.
size_t componentsOf(ParamType type);

Vec2 vec2At(const std::vector<double>& numbers, size_t index);
Vec3 vec3At(const std::vector<double>& numbers, size_t index);
// Whether a number of type 'integer' may have this value: a whole one from -2^31 to 2^31 - 1.
bool isInteger(double number);

}  // namespace drc::pbrt
