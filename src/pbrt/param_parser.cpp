#include "pbrt/param_parser.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "base/suggest.h"
#include "image/color.h"
#include "pbrt/illuminants.h"
#include "pbrt/metal_spectra.h"
#include "pbrt/named_spectra.h"
#include "pbrt/normalized_name.h"
#include "pbrt/spectrum.h"

namespace drc::pbrt {
namespace {

constexpr std::string_view kBlanks = " \t\n\r";

// How a colour is used. Indices of refraction, scattering coefficients and the like are three numbers for red, green
// and blue, not colours.
enum class ColorUse { Light, Reflectance, Index };

ColorUse useOf(const std::string& param, const ColorRules& rules) {
    if (rules.isLight || param == "Le") return ColorUse::Light;
    for (const std::string_view name : {"eta", "k", "sigma_a", "sigma_s", "mfp"})
        if (param == name || param.ends_with("." + std::string(name))) return ColorUse::Index;
    return ColorUse::Reflectance;
}

class ParamParser {
  public:
    ParamParser(TokenStream& tokens, const FileSearch& files, const std::string& owner, const ColorRules& rules)
        : tokens_(tokens), files_(files), owner_(owner), rules_(rules) {}

    Param parse() {
        declaration(tokens_.next());
        values();
        convert();
        return std::move(param_);
    }

  private:
    void declaration(const Token& token) {
        const std::string text = token.value();
        ParamName declared = paramNameOf(text);
        if (declared.name.empty())
            fail(token.pos, "expected a parameter of " + owner_ + " as \"type name\", found " + token.describe());
        if (declared.hasMore)
            fail(token.pos, "expected one type and one name in the parameter \"" + text + "\" of " + owner_);
        param_.typeName = std::move(declared.type);
        param_.name = std::move(declared.name);
        param_.pos = token.pos;
        const auto type = paramTypeNamed(param_.typeName);
        if (!type)
            fail(token.pos, "unknown type '" + param_.typeName + "' of parameter '" + param_.name + "' of " + owner_ +
                                suggestion(param_.typeName,
                                           {"float", "integer", "bool", "string", "point", "point2", "vector",
                                            "vector2", "normal", "rgb", "xyz", "blackbody", "spectrum", "texture"}));
        param_.type = *type;
    }

    void values() {
        const Token first = tokens_.next();
        param_.valuePos = first.pos;
        if (first.kind != TokenKind::OpenBracket) {
            value(first);
            return;
        }
        const bool takesNumbers =
            param_.type != ParamType::String && param_.type != ParamType::Texture && param_.type != ParamType::Bool;
        for (;;) {
            if (takesNumbers) tokens_.takeNumbers(param_.numbers);
            const Token& token = tokens_.peek();
            // An array must end in the file where it began, so its closing bracket is missing.
            if (token.kind == TokenKind::End || token.pos.source != first.pos.source)
                fail(first.pos,
                     "unterminated '[': the file ends before the ']' of parameter '" + param_.name + "' of " + owner_);
            if (token.kind == TokenKind::CloseBracket) break;
            value(token);
            tokens_.next();
        }
        tokens_.next();
    }

    void value(const Token& token) {
        const bool takesText = param_.type == ParamType::String || param_.type == ParamType::Texture;
        if (token.kind == TokenKind::Number && !takesText && param_.type != ParamType::Bool) {
            param_.numbers.push_back(token.number());
        } else if (token.kind == TokenKind::String && (takesText || param_.typeName == "spectrum")) {
            const bool isName = param_.type == ParamType::Texture;
            param_.strings.push_back(isName ? normalizedName(token.value(), rules_.dialect) : token.value());
        } else if (param_.type == ParamType::Bool &&
                   (token.kind == TokenKind::String || token.kind == TokenKind::Word) &&
                   (token.text == "true" || token.text == "false")) {
            param_.bools.push_back(token.text == "true");
        } else {
            const std::string expected = param_.type == ParamType::Bool  ? "\"true\" or \"false\""
                                         : takesText                     ? "a quoted string"
                                         : param_.typeName == "spectrum" ? "a number or the name of a .spd file"
                                                                         : "a number";
            const bool takesNumbers = param_.type != ParamType::Bool && !takesText;
            const std::string advice = takesNumbers                     ? token.whyNoNumber()
                                       : param_.type == ParamType::Bool ? adviceForBool(token)
                                                                        : "";
            fail(token.pos, "expected " + expected + " for parameter '" + param_.name + "' of type '" +
                                param_.typeName + "' of " + owner_ + ", found " + token.describe() + advice);
        }
    }

    static std::string adviceForBool(const Token& token) {
        std::string lower(token.text);
        std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
        if (lower == "true" || lower == "1" || lower == "yes" || lower == "on") return "; write true";
        if (lower == "false" || lower == "0" || lower == "no" || lower == "off") return "; write false";
        return "";
    }

    void checkGroups(size_t size) const {
        if (param_.numbers.size() % size == 0) return;
        fail(param_.valuePos, "parameter '" + param_.name + "' of " + owner_ + " is of type '" + param_.typeName +
                                  "' and takes numbers in groups of " + std::to_string(size) + ", found " +
                                  std::to_string(param_.numbers.size()));
    }

    void convert() {
        if (param_.type == ParamType::Color) {
            convertColors();
        } else if (param_.type == ParamType::Integer) {
            for (const double number : param_.numbers)
                if (!isInteger(number))
                    fail(param_.valuePos, "parameter '" + param_.name + "' of " + owner_ +
                                              " is of type 'integer' and takes whole numbers from -2^31 to 2^31 - 1");
        } else {
            checkGroups(componentsOf(param_.type));
        }
    }

    void convertColors() {
        if (param_.typeName == "spectrum") {
            checkGroups(2);
            const std::vector<double>& n = param_.numbers;
            std::vector<SpectrumSample> samples;
            for (size_t i = 0; i + 1 < n.size(); i += 2) samples.push_back({float(n[i]), float(n[i + 1])});
            if (samples.size() == 1 && beyond() == Beyond::Zero)
                warn(param_.valuePos, "the spectrum of parameter '" + param_.name + "' of " + owner_ +
                                          " has a single wavelength, and in pbrt-v4 is zero at all others");
            if (!samples.empty()) param_.colors.push_back(colorOf(std::move(samples), beyond()));
            for (const std::string& name : param_.strings) param_.colors.push_back(namedSpectrum(name));
        } else if (param_.typeName == "blackbody") {
            convertTemperatures();
        } else {
            checkGroups(3);
            for (size_t i = 0; i < param_.numbers.size() / 3; ++i) {
                const Vec3 c = vec3At(param_.numbers, i);
                if (rules_.dialect == Dialect::V4 && rules_.isLight && !(c.x >= 0 && c.y >= 0 && c.z >= 0))
                    fail(param_.valuePos, "parameter '" + param_.name + "' of " + owner_ +
                                              " is the colour of a light, and must not have a negative component");
                param_.colors.push_back(param_.typeName == "xyz" ? xyzToRgb(c) : fromSpace(Rgb(c.x, c.y, c.z)));
            }
        }
    }

    void convertTemperatures() {
        const std::vector<double>& n = param_.numbers;
        if (rules_.dialect == Dialect::V4) {
            if (n.size() != 1)
                fail(param_.valuePos, "parameter '" + param_.name + "' of " + owner_ +
                                          " is of type 'blackbody', which in pbrt-v4 is a temperature alone, found " +
                                          std::to_string(n.size()) + " numbers; how bright it is 'scale' says");
            if (!(n[0] > 0))
                fail(param_.valuePos, "parameter '" + param_.name + "' of " + owner_ +
                                          " is of type 'blackbody', whose temperature must be above 0 kelvin");
            param_.colors.push_back(scaled(blackbodyToRgb(float(n[0]))));
            return;
        }
        checkGroups(2);
        for (size_t i = 0; i + 1 < n.size(); i += 2)
            param_.colors.push_back(blackbodyToRgb(float(n[i])) * float(n[i + 1]));
    }

    // Converts from the colour space of the ColorSpace directive.
    Rgb fromSpace(const Rgb& c) const {
        if (rules_.dialect == Dialect::V3 || rules_.space == &ColorSpace::srgb()) return c;
        switch (useOf(param_.name, rules_)) {
            case ColorUse::Light:
                return rules_.space->light(c);
            case ColorUse::Reflectance:
                return rules_.space->reflectance(c);
            case ColorUse::Index:
                break;
        }
        return c;
    }

    // pbrt-v4 scales spectra of lights to a luminance of one.
    Rgb scaled(const Rgb& c) const {
        const bool isLight = useOf(param_.name, rules_) == ColorUse::Light;
        return rules_.dialect == Dialect::V4 && isLight ? atUnitLuminance(c) : c;
    }

    // How a spectrum in the file continues beyond its end samples. For indices of refraction, zero would make no sense.
    Beyond beyond() const {
        const bool isIndex = useOf(param_.name, rules_) == ColorUse::Index;
        return rules_.dialect == Dialect::V4 && !isIndex ? Beyond::Zero : Beyond::Constant;
    }

    Rgb colorOf(std::vector<SpectrumSample> samples, Beyond beyond) const {
        if (rules_.dialect == Dialect::V4 && useOf(param_.name, rules_) == ColorUse::Reflectance)
            return reflectanceToRgb(std::move(samples), beyond);
        return scaled(spectrumToRgb(std::move(samples), beyond));
    }

    Rgb namedSpectrum(const std::string& name) const {
        if (auto index = namedIndex(name)) return colorOf(std::move(*index), Beyond::Constant);
        if (const auto illuminant = illuminantNamed(name)) return *illuminant;
        const auto metal = metalSpectrum(name);
        std::string path;
        try {
            path = files_.find(name, param_.valuePos, "spectrum file");
        } catch (const Error&) {
            if (!metal) throw;
            warn(param_.valuePos,
                 "cannot find the spectrum file '" + name + "'; measurements of this metal stand in for it");
            return colorOf(*metal, Beyond::Constant);
        }
        return colorOf(placedAt(param_.valuePos, [&] { return readSpdFile(path); }), beyond());
    }

    TokenStream& tokens_;
    const FileSearch& files_;
    const std::string& owner_;
    const ColorRules& rules_;
    Param param_;
};

}  // namespace

ParamName paramNameOf(const std::string& text) {
    const size_t typeStart = text.find_first_not_of(kBlanks);
    const size_t typeEnd = text.find_first_of(kBlanks, typeStart);
    const size_t nameStart = text.find_first_not_of(kBlanks, typeEnd);
    if (typeStart == std::string::npos || nameStart == std::string::npos) return {};
    const size_t nameEnd = text.find_first_of(kBlanks, nameStart);
    return {text.substr(typeStart, typeEnd - typeStart), text.substr(nameStart, nameEnd - nameStart),
            text.find_first_not_of(kBlanks, nameEnd) != std::string::npos};
}

ParamSet parseParams(TokenStream& tokens, const std::string& owner, const SourcePos& pos, const FileSearch& files,
                     const ColorRules& rules) {
    ParamSet params(owner, pos);
    while (tokens.peek().kind == TokenKind::String) params.add(ParamParser(tokens, files, owner, rules).parse());
    return params;
}

}  // namespace drc::pbrt
