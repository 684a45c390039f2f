#include "pbrt/illuminants.h"

#include <array>

#include "image/color.h"
#include "pbrt/cie.h"

namespace drc::pbrt {
namespace {

// CIE 15, from 380 nm in steps of 10 nm; the standard itself is linear between these.
constexpr std::array<float, 41> kD65 = {
    49.9755f, 54.6482f, 82.7549f, 91.486f,  93.4318f, 86.6823f, 104.865f, 117.008f, 117.812f, 114.861f, 115.923f,
    108.811f, 109.354f, 107.802f, 104.79f,  107.689f, 104.405f, 104.046f, 100.0f,   96.3342f, 95.788f,  88.6856f,
    90.0062f, 89.5991f, 87.6987f, 83.2886f, 83.6992f, 80.0268f, 80.2146f, 82.2778f, 78.2842f, 69.7213f, 71.6091f,
    74.349f,  61.604f,  69.8856f, 75.087f,  63.5927f, 46.4182f, 66.8054f, 63.3828f};

// Chromaticities for the 2-degree observer (CIE 15; for ACES, SMPTE ST 2065-1).
struct Illuminant {
    std::string_view name;
    double x, y;
};
constexpr Illuminant kIlluminants[] = {
    {"stdillum-A", 0.44757, 0.40745},   {"stdillum-D50", 0.34567, 0.35850}, {"stdillum-D65", 0.3127, 0.3290},
    {"stdillum-F1", 0.31310, 0.33727},  {"stdillum-F2", 0.37208, 0.37529},  {"stdillum-F3", 0.40910, 0.39430},
    {"stdillum-F4", 0.44018, 0.40329},  {"stdillum-F5", 0.31379, 0.34531},  {"stdillum-F6", 0.37790, 0.38835},
    {"stdillum-F7", 0.31292, 0.32933},  {"stdillum-F8", 0.34588, 0.35875},  {"stdillum-F9", 0.37417, 0.37281},
    {"stdillum-F10", 0.34609, 0.35986}, {"stdillum-F11", 0.38052, 0.37713}, {"stdillum-F12", 0.43695, 0.40441},
    {"illum-acesD60", 0.32168, 0.33767}};

}  // namespace

float d65At(float nanometres) {
    const float at = (nanometres - kCieFirst) / 10;
    const size_t i = size_t(std::clamp(int(at), 0, int(kD65.size()) - 2));
    return kD65[i] + (at - float(i)) * (kD65[i + 1] - kD65[i]);
}

std::optional<Rgb> illuminantNamed(std::string_view name) {
    for (const Illuminant& i : kIlluminants)
        if (i.name == name) return xyzToRgb(Vec3(float(i.x / i.y), 1, float((1 - i.x - i.y) / i.y)));
    return std::nullopt;
}

}  // namespace drc::pbrt
