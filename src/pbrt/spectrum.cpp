#include "pbrt/spectrum.h"

#include <algorithm>
#include <cmath>

#include "base/limits.h"
#include "image/color.h"
#include "pbrt/cie.h"
#include "pbrt/illuminants.h"
#include "pbrt/tokenizer.h"

namespace drc::pbrt {
namespace {

// Integral of spectrum(nm) times the CIE observer, in steps of one nanometre as in pbrt, which narrow peaks require.
template <typename Spectrum>
Rgb integrate(const Spectrum& spectrum) {
    double x = 0, y = 0, z = 0, norm = 0;
    for (int nm = kCieFirst; nm <= kCieLast; ++nm) {
        const CieEntry cie = cieAt(float(nm));
        const double value = spectrum(double(nm));
        x += cie.x * value;
        y += cie.y * value;
        z += cie.z * value;
        norm += cie.y;
    }
    return xyzToRgb(Vec3(float(x / norm), float(y / norm), float(z / norm)));
}

// A piecewise linear function of wavelength from unsorted samples.
class Interpolated {
  public:
    Interpolated(std::vector<SpectrumSample> samples, Beyond beyond) : samples_(std::move(samples)), beyond_(beyond) {
        if (samples_.size() == 1 && beyond_ == Beyond::Zero) {
            const float at = samples_[0].wavelength;
            samples_.insert(samples_.end(), {{at - 1, 0}, {at + 1, 0}});
        }
        std::stable_sort(samples_.begin(), samples_.end(),
                         [](const auto& a, const auto& b) { return a.wavelength < b.wavelength; });
    }
    double operator()(double nm) const {
        const auto above = std::lower_bound(samples_.begin(), samples_.end(), nm,
                                            [](const SpectrumSample& s, double w) { return s.wavelength < w; });
        if (above == samples_.end()) return beyond_ == Beyond::Zero ? 0 : samples_.back().value;
        if (above == samples_.begin())
            return beyond_ == Beyond::Zero && nm < above->wavelength ? 0 : samples_.front().value;
        const SpectrumSample &a = above[-1], &b = above[0];
        const double t = (nm - a.wavelength) / (b.wavelength - a.wavelength);
        return a.value + t * (b.value - a.value);
    }

  private:
    std::vector<SpectrumSample> samples_;  // not empty
    Beyond beyond_;
};

double planck(double nm, double kelvin) {
    constexpr double kC2 = 1.438776877e7;  // second radiation constant, nm K
    const double l = nm * 1e-3;            // um, to stay within range; the factor cancels
    return 1 / (l * l * l * l * l * std::expm1(kC2 / (nm * kelvin)));
}

}  // namespace

Rgb spectrumToRgb(std::vector<SpectrumSample> samples, Beyond beyond) {
    if (samples.empty()) return Rgb(0.f);
    return integrate(Interpolated(std::move(samples), beyond));
}

Rgb reflectanceToRgb(std::vector<SpectrumSample> samples, Beyond beyond) {
    if (samples.empty()) return Rgb(0.f);
    const Interpolated reflectance(std::move(samples), beyond);
    static const Rgb kWhite = integrate([](double nm) { return double(d65At(float(nm))); });
    const Rgb c = integrate([&](double nm) { return reflectance(nm) * double(d65At(float(nm))); }) / kWhite;
    return Rgb(std::clamp(c.x, 0.f, 1.f), std::clamp(c.y, 0.f, 1.f), std::clamp(c.z, 0.f, 1.f));
}

std::vector<Rgb> reflectanceWeights(const std::vector<float>& wavelengths) {
    std::vector<Vec3> xyz(wavelengths.size(), Vec3(0, 0, 0));
    double norm = 0;
    for (int nm = kCieFirst; nm <= kCieLast; ++nm) {
        const CieEntry cie = cieAt(float(nm));
        const float light = d65At(float(nm));
        norm += double(light) * cie.y;
        // The two samples around the wavelength; beyond the ends, the end sample twice.
        const size_t above =
            size_t(std::lower_bound(wavelengths.begin(), wavelengths.end(), float(nm)) - wavelengths.begin());
        const size_t first = above == 0 ? 0 : above - 1, second = std::min(above, wavelengths.size() - 1);
        const float t =
            first == second ? 0 : (float(nm) - wavelengths[first]) / (wavelengths[second] - wavelengths[first]);
        const Vec3 response = Vec3(cie.x, cie.y, cie.z) * light;
        xyz[first] += response * (1 - t);
        xyz[second] += response * t;
    }
    std::vector<Rgb> weights;
    Rgb white(0.f);
    for (const Vec3& v : xyz) {
        weights.push_back(xyzToRgb(v * float(1 / norm)));
        white += weights.back();
    }
    for (Rgb& w : weights) w /= white;
    return weights;
}

Rgb atUnitLuminance(const Rgb& color) {
    const Rgb inGamut = clampNonNegative(color);
    const float y = luminance(inGamut);
    return y > 0 ? inGamut / y : Rgb(0.f);
}

Rgb blackbodyToRgb(float kelvin) {
    if (!(kelvin > 0)) return Rgb(0.f);
    constexpr double kWien = 2.897771955e6;  // nm K
    const double maximum = planck(kWien / kelvin, kelvin);
    return integrate([&](double nm) { return planck(nm, kelvin) / maximum; });
}

std::vector<SpectrumSample> readSpdFile(const std::string& path) {
    const auto source = Source::fromFile(path, "spectrum file", limits::kTableBytes);
    Tokenizer tokenizer(*source);
    std::vector<SpectrumSample> samples;
    for (Token token = tokenizer.next(); token.kind != TokenKind::End; token = tokenizer.next()) {
        const Token value = tokenizer.next();
        if (value.kind == TokenKind::End) fail(token.pos, "the last wavelength of the spectrum has no value");
        samples.push_back({float(token.number()), float(value.number())});
    }
    if (samples.empty()) throw Error({path, 0, 0}, "the spectrum file holds no samples");
    return samples;
}

}  // namespace drc::pbrt
