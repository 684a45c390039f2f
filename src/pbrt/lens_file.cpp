#include "pbrt/lens_file.h"

#include <fmt/core.h>

#include <charconv>

#include "base/limits.h"
#include "pbrt/source.h"

namespace drc::pbrt {
namespace {

constexpr float kMetres = 1e-3f;  // per millimetre

struct Number {
    float value;
    SourcePos pos;
};

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }

std::vector<Number> numbersOf(const Source& source) {
    const std::string_view text = source.text();
    std::vector<Number> numbers;
    for (size_t i = 0; i < text.size();) {
        if (isSpace(text[i])) {
            ++i;
        } else if (text[i] == '#') {
            i = std::min(text.size(), text.find('\n', i));
        } else {
            size_t end = i;
            while (end < text.size() && !isSpace(text[end]) && text[end] != '#') ++end;
            const SourcePos pos{&source, i};
            float value = 0;
            const char* first = text.data() + i + (text[i] == '+' ? 1 : 0);
            const auto parsed = std::from_chars(first, text.data() + end, value);
            if (parsed.ec != std::errc() || parsed.ptr != text.data() + end || !std::isfinite(value))
                fail(pos, "'" + std::string(text.substr(i, end - i)) +
                              "' is no number; a lens file has four for each "
                              "surface: radius, distance to the next, index of refraction, diameter");
            numbers.push_back({value, pos});
            i = end;
        }
    }
    return numbers;
}

}  // namespace

std::vector<LensElement> readLensFile(const std::string& path, float stopDiameter) {
    const auto source = Source::fromFile(path, "lens file", limits::kTableBytes);
    const std::vector<Number> numbers = numbersOf(*source);
    const SourcePos start{source.get(), 0};
    if (numbers.size() / 4 > limits::kLensSurfaces)
        fail(numbers[4 * limits::kLensSurfaces].pos, fmt::format("a lens may have at most {} surfaces, this one has {}",
                                                                 limits::kLensSurfaces, numbers.size() / 4));
    if (numbers.empty() || numbers.size() % 4 != 0)
        fail(numbers.empty() ? start : numbers.back().pos,
             fmt::format("a lens file has four numbers for each surface: this one has {} in all", numbers.size()));
    std::vector<LensElement> lens;
    bool stop = false;
    for (size_t i = 0; i < numbers.size(); i += 4) {
        LensElement e;
        e.radius = numbers[i].value * kMetres;
        e.thickness = numbers[i + 1].value * kMetres;
        e.eta = numbers[i + 2].value;
        float diameter = numbers[i + 3].value;
        // The last distance, to the film, is determined by focusing; in pbrt's own files it is 0.
        const bool isLast = i + 4 == numbers.size();
        if (!isLast && !(e.thickness >= 0))
            fail(numbers[i + 1].pos, "the distance to the next surface must not be negative");
        // An aperture stop has no index of refraction; some files contain 0 for it.
        if (!(e.eta >= 1 || e.eta == 0)) fail(numbers[i + 2].pos, "the index of refraction must be 1 or more");
        if (!(diameter > 0)) fail(numbers[i + 3].pos, "the diameter must be positive");
        if (e.radius == 0) {
            stop = true;
            if (stopDiameter > diameter)
                warn(numbers[i + 3].pos,
                     fmt::format("the stop opens to {:g} mm, not to the {:g} mm that the camera's 'aperturediameter' "
                                 "asks for",
                                 diameter, stopDiameter));
            diameter = std::min(diameter, stopDiameter);
        }
        e.aperture = 0.5f * diameter * kMetres;
        lens.push_back(e);
    }
    if (!stop) warn(start, "this lens has no stop (a surface of radius 0): 'aperturediameter' has no effect");
    return lens;
}

}  // namespace drc::pbrt
