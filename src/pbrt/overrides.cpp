#include "pbrt/overrides.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "base/suggest.h"

namespace drc::pbrt {
namespace {

constexpr std::string_view kBetween = " \t,";

// The parameters that the front end looks up for a directive. No list of them exists, so this applies the directive to
// an empty set and records the look-ups.
ParamSet::Known knownTo(const Overrides::Directive& directive) {
    ParamSet::Known known;
    ParamSet none(directive.params.owner(), directive.params.pos());
    none.noteLookups(known);
    RenderSettings unused;
    directive.apply(directive.type, none, unused);
    return known;
}

class Reader {
  public:
    Reader(const Source& source, const std::vector<Overrides::Directive>& directives,
           const std::vector<ParamSet::Known>& known)
        : source_(source), directives_(directives), known_(known) {}

    void apply() {
        const std::string_view text = source_.text();
        const size_t equals = text.find('=');
        if (equals == std::string_view::npos || equals == 0)
            fail(at(0), "a parameter is given as NAME=VALUE, such as film.xresolution=640");
        name_ = text.substr(0, equals);
        value_ = text.substr(equals + 1);
        valueStart_ = equals + 1;
        const size_t dot = name_.find('.');
        const size_t directive = dot == std::string_view::npos ? onlyOneThatKnows() : directiveNamed(dot);
        directives_[directive].params.replace(param(directive));
    }

  private:
    SourcePos at(size_t offset) const { return {&source_, offset}; }

    size_t directiveNamed(size_t dot) {
        const std::string_view wanted = name_.substr(0, dot);
        size_t found = 0;
        while (found < directives_.size() && directives_[found].name != wanted) ++found;
        if (found == directives_.size())
            fail(at(0), fmt::format("there are parameters of {}, not of '{}'",
                                    listed(", ", [](size_t) { return true; }), wanted));
        name_.remove_prefix(dot + 1);
        nameStart_ = dot + 1;
        const ParamSet::Known& known = known_[found];
        if (known.types.contains(name_) || known.anything) return found;
        fail(at(nameStart_), fmt::format("{} has no parameter '{}'{}; it has {}", directives_[found].params.owner(),
                                         name_, suggestion(name_, namesOf(known)), fmt::join(namesOf(known), ", ")));
    }

    size_t onlyOneThatKnows() const {
        const auto knows = [&](size_t i) { return known_[i].types.contains(name_); };
        size_t found = directives_.size(), count = 0;
        for (size_t i = directives_.size(); i-- > 0;)
            if (knows(i)) found = i, ++count;
        if (count == 1) return found;
        if (count > 1)
            fail(at(0), fmt::format("{1} have a parameter '{0}': say which, as {2}.{0}", name_, listed(" and ", knows),
                                    directives_[found].name));
        std::string names;
        for (size_t i = 0; i < directives_.size(); ++i)
            names += fmt::format("; {} has {}", directives_[i].params.owner(), fmt::join(namesOf(known_[i]), ", "));
        fail(at(0), fmt::format("no parameter is called '{}'{}", name_, names));
    }

    template <typename Which>
    std::string listed(std::string_view between, const Which& which) const {
        std::vector<std::string_view> names;
        for (size_t i = 0; i < directives_.size(); ++i)
            if (which(i)) names.push_back(directives_[i].name);
        return fmt::format("{}", fmt::join(names, between));
    }

    static std::vector<std::string_view> namesOf(const ParamSet::Known& known) {
        std::vector<std::string_view> names;
        for (const auto& entry : known.types) names.push_back(entry.first);
        return names;
    }

    Param param(size_t directive) const {
        const auto known = known_[directive].types.find(name_);
        Param p;
        // A parameter without effect accepts any value.
        p.type = known != known_[directive].types.end() ? known->second.value_or(ParamType::String) : ParamType::String;
        p.typeName = describe(p.type);
        p.name = name_;
        p.pos = at(nameStart_);
        p.valuePos = at(valueStart_);
        const auto expect = [&](const std::string& what, std::string_view found) {
            fail(p.valuePos, fmt::format("parameter '{}' of {} is {}, not '{}'", name_,
                                         directives_[directive].params.owner(), what, found));
        };
        if (p.type == ParamType::String) {
            p.strings.emplace_back(value_);
        } else if (p.type == ParamType::Bool) {
            if (value_ != "true" && value_ != "false") expect("true or false", value_);
            p.bools.push_back(value_ == "true");
        } else {
            for (size_t end = 0;;) {
                const size_t begin = value_.find_first_not_of(kBetween, end);
                if (begin == std::string_view::npos) break;
                end = std::min(value_.find_first_of(kBetween, begin), value_.size());
                const std::string_view word = value_.substr(begin, end - begin);
                const auto number = numberOf(word);
                if (!number) expect("a number", word);
                if (p.type == ParamType::Integer && !isInteger(*number))
                    expect("a whole number from -2^31 to 2^31 - 1", word);
                p.numbers.push_back(*number);
            }
        }
        return p;
    }

    static std::optional<double> numberOf(std::string_view word) {
        if (word.starts_with("+")) word.remove_prefix(1);
        double number = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(number)) return std::nullopt;
        return number;
    }

    const Source& source_;
    const std::vector<Overrides::Directive>& directives_;
    const std::vector<ParamSet::Known>& known_;
    std::string_view name_, value_;
    size_t nameStart_ = 0, valueStart_ = 0;
};

}  // namespace

Overrides::Overrides(const std::vector<std::string>& texts, const std::vector<Directive>& directives) {
    if (texts.empty()) return;
    std::vector<ParamSet::Known> known;
    for (const Directive& directive : directives) known.push_back(knownTo(directive));
    for (const std::string& text : texts) {
        sources_.push_back(Source::fromText(text, "-D", "."));
        Reader(*sources_.back(), directives, known).apply();
    }
}

}  // namespace drc::pbrt
