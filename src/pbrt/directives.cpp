#include "pbrt/directives.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "base/log.h"
#include "base/suggest.h"
#include "pbrt/render_settings.h"

namespace drc::pbrt {
namespace {

using Context = const DirectiveContext&;

std::string text(Context c, const std::string& purpose) {
    return c.tokens.expectString(purpose + " of " + std::string(c.name)).value();
}

// Reads N numbers, with or without brackets.
template <size_t N>
std::array<double, N> numbers(Context c) {
    const bool bracketed = c.tokens.peek().kind == TokenKind::OpenBracket;
    if (bracketed) c.tokens.next();
    std::array<double, N> result;
    for (size_t i = 0; i < N; ++i)
        result[i] = c.tokens.expectNumber("number " + std::to_string(i + 1) + " of the " + std::to_string(N) + " of " +
                                          std::string(c.name));
    if (bracketed) {
        const Token close = c.tokens.next();
        if (close.kind != TokenKind::CloseBracket)
            fail(close.pos, "expected ']' after the " + std::to_string(N) + " numbers of " + std::string(c.name) +
                                ", found " + close.describe());
    }
    return result;
}

// A quoted type with parameters, such as "sphere" "float radius" 2.
struct Typed {
    std::string type;
    ParamSet params;
};
Typed typed(Context c, const std::string& kind) {
    Typed result;
    const Token token = c.tokens.expectString("the type of " + std::string(c.name));
    result.type = token.value();
    checkDialect(c.dialect, c.name, result.type, token.pos);
    const bool isLight = c.name == "LightSource" || c.name == "AreaLightSource";
    result.params =
        parseParams(c.tokens, kind + " '" + result.type + "'", token.pos, c.files, c.builder.colorRules(isLight));
    return result;
}

Vec3 vec3(const double* v) { return Vec3(float(v[0]), float(v[1]), float(v[2])); }

// Files store matrices column by column. A last row of 0 0 0 w divides all points by w. Dividing the whole matrix by w
// gives the same transformation with a last row of 0 0 0 1, which instances, and shapes other than meshes, need.
Transform matrix(Context c) {
    const auto m = numbers<16>(c);
    const double w = m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] != 0 ? m[15] : 1;
    std::array<double, 16> rows;
    for (size_t row = 0; row < 4; ++row)
        for (size_t column = 0; column < 4; ++column) rows[4 * row + column] = m[4 * column + row] / w;
    return Transform(rows);
}

void translate(Context c) { c.builder.apply(Transform::translate(vec3(numbers<3>(c).data())), c.pos); }

void scale(Context c) {
    const auto v = numbers<3>(c);
    c.builder.apply(Transform::scale(float(v[0]), float(v[1]), float(v[2])), c.pos);
}

void rotate(Context c) {
    const auto v = numbers<4>(c);
    c.builder.apply(Transform::rotate(float(v[0]), vec3(&v[1])), c.pos);
}

void lookAt(Context c) {
    const auto v = numbers<9>(c);
    const Vec3 direction = vec3(&v[3]) - vec3(&v[0]), up = vec3(&v[6]);
    if (direction == Vec3(0.f)) fail(c.pos, "LookAt looks from a point to the same point; the second must be another");
    if (up == Vec3(0.f)) fail(c.pos, "the up vector of LookAt, its last three numbers, is zero");
    if (length(cross(normalize(up), normalize(direction))) < 1e-6f)
        fail(c.pos, "LookAt looks along its up vector (the last three numbers); choose another up vector");
    c.builder.apply(Transform::lookAt(vec3(&v[0]), vec3(&v[3]), vec3(&v[6])), c.pos);
}

void activeTransform(Context c) {
    const Token which = c.tokens.next();
    if (which.text == "All")
        c.builder.setActiveTransforms(true, true);
    else if (which.text == "StartTime")
        c.builder.setActiveTransforms(true, false);
    else if (which.text == "EndTime")
        c.builder.setActiveTransforms(false, true);
    else
        fail(which.pos, "expected All, StartTime or EndTime after ActiveTransform, found " + which.describe());
}

void transformTimes(Context c) {
    const auto times = numbers<2>(c);
    c.builder.transformTimes(float(times[0]), float(times[1]), c.pos);
}

void include(Context c) {
    const Token name = c.tokens.expectString("the file of " + std::string(c.name));
    c.tokens.include(c.files.find(name.value(), name.pos, "file to include"), name.pos);
}

// Like Include, but the end of the file restores the graphics state. The parser ends the block.
void import(Context c) {
    c.builder.beginBlock("Import", c.pos);
    include(c);
}

void attribute(Context c) {
    const Token target = c.tokens.expectString("the target of Attribute");
    const ParamSet params = parseParams(c.tokens, "attribute '" + target.value() + "'", c.pos, c.files,
                                        c.builder.colorRules(target.value() == "light"));
    c.builder.attribute(target.value(), params, target.pos);
}

void colorSpace(Context c) {
    const Token name = c.tokens.expectString("the name of ColorSpace");
    c.builder.colorSpace(name.value(), name.pos);
}

// Options concern pbrt's own way of rendering, except for a few that change the picture.
void option(Context c) {
    const std::vector<std::string_view> known = {"debugstart",
                                                 "disablepixeljitter",
                                                 "disabletexturefiltering",
                                                 "disablewavelengthjitter",
                                                 "displacementedgescale",
                                                 "forcediffuse",
                                                 "msereferenceimage",
                                                 "msereferenceout",
                                                 "pixelstats",
                                                 "rendercoordsys",
                                                 "seed",
                                                 "wavefront"};
    if (c.tokens.peek().kind != TokenKind::String)
        fail(c.tokens.peek().pos, "expected an option as \"type name\", found " + c.tokens.peek().describe());
    const ParamSet params = parseParams(c.tokens, "Option", c.pos, c.files);
    for (const Param& param : params.all()) {
        if (std::find(known.begin(), known.end(), param.name) == known.end())
            warn(param.pos, "unknown option '" + param.name + "'; ignored" + suggestion(param.name, known));
        else if (param.name == "forcediffuse" && params.getBool("forcediffuse", false))
            warn(param.pos, "option 'forcediffuse' is not supported yet; ignored");
        else
            logDebug("option '" + param.name + "' has no effect");
    }
}

void objectInstance(Context c) {
    const Token name = c.tokens.expectString("the name of ObjectInstance");
    c.builder.objectInstance(name.value(), name.pos);
}

void namedMaterial(Context c) {
    const Token name = c.tokens.expectString("the name of NamedMaterial");
    c.builder.namedMaterial(name.value(), name.pos);
}

void makeNamedMaterial(Context c) {
    const Token token = c.tokens.expectString("the name of MakeNamedMaterial");
    const std::string name = token.value();
    ParamSet params = parseParams(c.tokens, "material '" + name + "'", token.pos, c.files, c.builder.colorRules(false));
    if (const Param* type = params.findIfTyped("type", {ParamType::String}); type != nullptr && type->count() == 1)
        checkDialect(c.dialect, c.name, type->strings[0], type->valuePos);
    c.builder.makeNamedMaterial(name, std::move(params));
}

void texture(Context c) {
    const std::string name = text(c, "the name");
    const Token valueType = c.tokens.expectString("the value type, 'float' or 'spectrum', of Texture");
    const Token type = c.tokens.expectString("the type of Texture");
    checkDialect(c.dialect, c.name, type.value(), type.pos);
    c.builder.texture(name, valueType.value(), type.value(),
                      parseParams(c.tokens, "texture '" + name + "'", type.pos, c.files, c.builder.colorRules(false)));
}

void makeNamedMedium(Context c) {
    const std::string name = text(c, "the name");
    c.builder.makeNamedMedium(
        name, parseParams(c.tokens, "medium '" + name + "'", c.pos, c.files, c.builder.colorRules(false)));
}

void mediumInterface(Context c) {
    const Token inside = c.tokens.expectString("the inside medium of MediumInterface");
    // A single name applies to both sides.
    const Token outside = c.tokens.peek().kind == TokenKind::String ? c.tokens.next() : inside;
    c.builder.mediumInterface(inside, outside);
}

// A directive of the form  Name "type" parameters. kind is used in messages.
void addTyped(Context c, const std::string& kind, void (SceneBuilder::*add)(const std::string&, ParamSet)) {
    Typed t = typed(c, kind);
    (c.builder.*add)(t.type, std::move(t.params));
}

void accelerator(Context c) {
    const Typed t = typed(c, "accelerator");
    checkAccelerator(t.type, t.params);
}

using enum DirectiveScope;
constexpr Directive kDirectives[] = {
    {"Accelerator", Options, accelerator},
    {"ActiveTransform", Any, activeTransform},
    {"AreaLightSource", World, [](Context c) { addTyped(c, "area light", &SceneBuilder::areaLight); }},
    {"Attribute", Any, attribute},
    {"AttributeBegin", World, [](Context c) { c.builder.beginBlock("Attribute", c.pos); }},
    {"AttributeEnd", World, [](Context c) { c.builder.endBlock("Attribute", c.pos); }},
    {"Camera", Options, [](Context c) { addTyped(c, "camera", &SceneBuilder::camera); }},
    {"ColorSpace", Any, colorSpace},
    {"ConcatTransform", Any, [](Context c) { c.builder.apply(matrix(c), c.pos); }},
    {"CoordSysTransform", Any, [](Context c) { c.builder.useCoordinateSystem(text(c, "the name"), c.pos); }},
    {"CoordinateSystem", Any, [](Context c) { c.builder.nameCoordinateSystem(text(c, "the name")); }},
    {"Film", Options, [](Context c) { addTyped(c, "film", &SceneBuilder::film); }},
    {"Identity", Any, [](Context c) { c.builder.setTransform(Transform(), c.pos); }},
    {"Import", World, import},
    {"Include", Any, include},
    {"Integrator", Options, [](Context c) { addTyped(c, "integrator", &SceneBuilder::integrator); }},
    {"LightSource", World, [](Context c) { addTyped(c, "light", &SceneBuilder::light); }},
    {"LookAt", Any, lookAt},
    {"MakeNamedMaterial", World, makeNamedMaterial},
    {"MakeNamedMedium", Any, makeNamedMedium},
    {"Material", World, [](Context c) { addTyped(c, "material", &SceneBuilder::material); }},
    {"MediumInterface", Any, mediumInterface},
    {"NamedMaterial", World, namedMaterial},
    {"ObjectBegin", World, [](Context c) { c.builder.objectBegin(text(c, "the name"), c.pos); }},
    {"ObjectEnd", World, [](Context c) { c.builder.objectEnd(c.pos); }},
    {"ObjectInstance", World, objectInstance},
    {"Option", Options, option},
    {"PixelFilter", Options, [](Context c) { addTyped(c, "pixel filter", &SceneBuilder::filter); }},
    {"ReverseOrientation", World, [](Context c) { c.builder.reverseOrientation(); }},
    {"Rotate", Any, rotate},
    {"Sampler", Options, [](Context c) { addTyped(c, "sampler", &SceneBuilder::sampler); }},
    {"Scale", Any, scale},
    {"Shape", World, [](Context c) { addTyped(c, "shape", &SceneBuilder::shape); }},
    {"Texture", World, texture},
    {"Transform", Any, [](Context c) { c.builder.setTransform(matrix(c), c.pos); }},
    {"TransformBegin", World, [](Context c) { c.builder.beginBlock("Transform", c.pos); }},
    {"TransformEnd", World, [](Context c) { c.builder.endBlock("Transform", c.pos); }},
    {"TransformTimes", Options, transformTimes},
    {"Translate", Any, translate},
    {"WorldBegin", Options, [](Context c) { c.builder.worldBegin(c.pos); }},
    {"WorldEnd", World, [](Context c) { c.builder.worldEnd(c.pos); }},
};

}  // namespace

const Directive& findDirective(const Token& word) {
    static const auto byName = [] {
        std::unordered_map<std::string_view, const Directive*> map;
        for (const Directive& directive : kDirectives) map[directive.name] = &directive;
        return map;
    }();
    const auto found = byName.find(word.text);
    if (found != byName.end()) return *found->second;
    std::vector<std::string_view> names;
    for (const Directive& directive : kDirectives) names.push_back(directive.name);
    fail(word.pos, "unknown directive " + word.describe() + suggestion(word.text, names));
}

}  // namespace drc::pbrt
