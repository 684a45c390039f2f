// Every kind of light of pbrt-v4 with every way to give its spectrum, against colours that are integrated here.
#include <gmock/gmock.h>

#include <functional>

#include "base/log.h"
#include "pbrt/cie.h"
#include "pbrt/glass_spectra.h"
#include "pbrt/metal_spectra.h"
#include "pbrt/test_scenes.h"
#include "scene/scene.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

// XYZ to linear Rec. 709 (IEC 61966-2-1), with a luminance of one.
Rgb colorOf(double x, double y, double z) {
    const Rgb rgb(float((3.2406 * x - 1.5372 * y - 0.4986 * z) / y), float((-0.9689 * x + 1.8758 * y + 0.0415 * z) / y),
                  float((0.0557 * x - 0.2040 * y + 1.0570 * z) / y));
    const Rgb clamped(std::max(0.f, rgb.x), std::max(0.f, rgb.y), std::max(0.f, rgb.z));
    return clamped / (0.2126f * clamped.x + 0.7152f * clamped.y + 0.0722f * clamped.z);
}
Rgb byIntegration(const std::function<double(double nm)>& spectrum) {
    double x = 0, y = 0, z = 0;
    for (double nm = kCieFirst; nm <= kCieLast; ++nm) {  // as pbrt sums
        const CieEntry cie = cieAt(float(nm));
        const double value = spectrum(nm);
        x += double(cie.x) * value;
        y += double(cie.y) * value;
        z += double(cie.z) * value;
    }
    return colorOf(x, y, z);
}
Rgb byChromaticity(double x, double y) { return colorOf(x / y, 1, (1 - x - y) / y); }

// Planck's law, up to a factor.
double planck(double nm, double kelvin) { return std::pow(nm * 1e-3, -5) / std::expm1(1.438776877e7 / (nm * kelvin)); }
// Linear between the samples, and constant beyond them.
std::function<double(double)> interpolated(const std::vector<SpectrumSample>& samples) {
    return [samples](double nm) {
        if (nm <= double(samples.front().wavelength)) return double(samples.front().value);
        for (size_t i = 1; i < samples.size(); ++i) {
            const double a = double(samples[i - 1].wavelength), b = double(samples[i].wavelength);
            if (nm <= b)
                return double(samples[i - 1].value) +
                       (nm - a) / (b - a) * double(samples[i].value - samples[i - 1].value);
        }
        return double(samples.back().value);
    };
}
// Chromaticity of the CIE's daylight of a correlated colour temperature from 4000 to 7000 K (CIE 15).
Rgb daylight(double kelvin) {
    const double t = 1000 / kelvin, x = -4.6070 * t * t * t + 2.9678 * t * t + 0.09911 * t + 0.244063;
    return byChromaticity(x, -3 * x * x + 2.87 * x - 0.275);
}

struct Way {
    const char *name, *type, *value;
    Rgb expected;
};
std::vector<Way> ways() {
    return {
        {"Rgb", "rgb", "[0.5 1 2]", Rgb(0.5f, 1, 2)},
        {"Blackbody", "blackbody", "4500", byIntegration([](double nm) { return planck(nm, 4500); })},
        {"BlackbodyOfEmbers", "blackbody", "[1100]", byIntegration([](double nm) { return planck(nm, 1100); })},
        {"Pairs", "spectrum", "[500 1 600 3]",
         byIntegration([](double nm) { return nm < 500 || nm > 600 ? 0 : 1 + (nm - 500) / 50; })},
        {"PairsOfTheWholeRange", "spectrum", "[360 7 830 7]", byIntegration([](double) { return 1; })},
        {"File", "spectrum", "\"lamp.spd\"",
         byIntegration([](double nm) { return nm < 450 || nm > 650 ? 0 : 650 - nm; })},
        // CIE 15: a black body of 2848 K with the second radiation constant of 1931.
        {"IlluminantA", "spectrum", "\"stdillum-A\"",
         byIntegration([](double nm) { return std::pow(nm * 1e-3, -5) / std::expm1(1.435e7 / (nm * 2848)); })},
        {"IlluminantD50", "spectrum", "\"stdillum-D50\"", daylight(5003)},
        {"IlluminantD65", "spectrum", "\"stdillum-D65\"", daylight(6504)},
        {"AcesD60", "spectrum", "\"illum-acesD60\"", daylight(6000)},
        {"Metal", "spectrum", "\"metal-CuZn-eta\"", byIntegration(interpolated(*metalSpectrum("metal-CuZn-eta")))},
        {"Glass", "spectrum", "\"glass-BK7\"", byIntegration(interpolated(*glassSpectrum("glass-BK7")))},
    };
}
void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

// Light at the origin, or of the sky, along +z; and the parameter that sets its brightness, with the value that it has
// for a white light of one.
struct Kind {
    const char *name, *text, *parameter, *target;
    double own;
    std::function<Rgb(const Scene&)> measure;
};
std::vector<Kind> kinds() {
    const auto arriving = [](const Scene& scene) {
        const auto s = scene.lights.at(0)->sample(Vec3(0, 0, 1), Vec2(0.5f, 0.5f));
        return s ? s->radiance : Rgb(0.f);
    };
    const auto escaped = [](const Scene& scene) {
        return scene.lights.at(0)->escaped(Vec3(0.f), normalize(Vec3(0.1f, 0.1f, 1)));
    };
    const auto emitted = [](const Scene& scene) {
        return scene.primitives.at(0).areaLight->emitted({Vec3(0.f), Vec3(0, 0, 1)}, Vec3(0, 0, 1));
    };
    const double pi = std::numbers::pi;
    // Half of the cosine between the edge and full intensity counts.
    const double cone = 2 * pi * (1 - (std::cos(25 * pi / 180) + std::cos(30 * pi / 180)) / 2);
    return {{"Point", "LightSource \"point\"", "I", "power", 4 * pi, arriving},
            {"Spot", "LightSource \"spot\"", "I", "power", cone, arriving},
            {"Goniometric", "LightSource \"goniometric\"", "I", "power", 4 * pi, arriving},
            {"Distant", "LightSource \"distant\"", "L", "illuminance", 1, arriving},
            {"Infinite", "LightSource \"infinite\"", "L", "illuminance", pi, escaped},
            {"Portal", "LightSource \"infinite\" \"point3 portal\" [-1 -1 1  -1 1 1  1 1 1  1 -1 1]", "L",
             "illuminance", pi, escaped},
            {"Area", "AreaLightSource \"diffuse\"", "L", "power", pi * pi, emitted},
            {"AttributeOfArea", "AttributeBegin AreaLightSource \"diffuse\"", "L", "power", pi * pi, emitted}};
}

class LightSpectra : public testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(V4, LightSpectra, testing::ValuesIn(ways()), [](const auto& i) { return i.param.name; });

TEST_P(LightSpectra, AreTheSameForEveryLight) {
    const TemporaryFolder folder;
    folder.write("lamp.spd", "# a lamp\n450 200\n550 100\n650 0\n");
    const Way& way = GetParam();
    for (const Kind& kind : kinds()) {
        const auto colorOf = [&](const std::string& brightness) {
            const std::string parameter =
                std::string(" \"") + way.type + " " + kind.parameter + "\" " + way.value + " ";
            std::string text = kind.text + parameter + brightness;
            if (kind.measure.target_type() == kinds().back().measure.target_type()) text += "\nShape \"disk\"\n";
            if (std::string(kind.text).starts_with("AttributeBegin")) text += "AttributeEnd\n";
            return kind.measure(*loadWorldV4(text, folder.path()));
        };
        const auto expectColor = [&](const Rgb& color, double factor) {
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(color[c] / factor, way.expected[c], 4e-3f * (1 + way.expected[c]))
                    << kind.name << " channel " << c;
        };
        forgetWarnings();
        expectColor(colorOf(""), 1);
        expectColor(colorOf("\"float scale\" 3"), 3);
        const std::string target = std::string("\"float ") + kind.target + "\" 20";
        expectColor(colorOf(target), 20 / kind.own);
        expectColor(colorOf(target + " \"float scale\" 0.5"), 10 / kind.own);
        EXPECT_EQ(warningCount(), 0) << kind.name;
    }
}

TEST(LightSpectraOfV4, MayBeDefaultsOfAttribute) {
    const auto scene =
        loadWorldV4("Attribute \"light\" \"blackbody L\" 4500\nAreaLightSource \"diffuse\"\nShape \"disk\"");
    const Rgb color = scene->primitives.at(0).areaLight->emitted({Vec3(0.f), Vec3(0, 0, 1)}, Vec3(0, 0, 1));
    const Rgb expected = byIntegration([](double nm) { return planck(nm, 4500); });
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], expected[c], 0.01f);
}

TEST(LightSpectraOfV4, BadOnes) {
    const TemporaryFolder folder;
    const auto error = [&](const std::string& parameter) {
        return errorOfWorldV4("LightSource \"point\" " + parameter, folder.path());
    };
    EXPECT_THAT(error("\"blackbody I\" 0"), AllOf(StartsWith("s.pbrt:2:35: "), HasSubstr("must be above 0 kelvin")));
    EXPECT_THAT(error("\"blackbody I\" -300"), HasSubstr("must be above 0 kelvin"));
    EXPECT_THAT(error("\"rgb I\" [1 -0.1 1]"), AllOf(StartsWith("s.pbrt:2:29: "), HasSubstr("a negative component")));
    EXPECT_THAT(error("\"spectrum I\" [400 1 500]"), HasSubstr("groups of 2, found 3"));
    EXPECT_THAT(error("\"spectrum I\" \"no-such\""), HasSubstr("cannot find the spectrum file 'no-such'"));
    folder.write("bad.spd", "400 1\n500\n");
    EXPECT_THAT(error("\"spectrum I\" \"bad.spd\""), HasSubstr("has no value"));
    folder.write("empty.spd", "# nothing\n");
    EXPECT_THAT(error("\"spectrum I\" \"empty.spd\""), HasSubstr("holds no samples"));
    // Outside the visible there is no light; a single wavelength is said to be one.
    EXPECT_TRUE(isBlack(loadWorldV4("LightSource \"point\" \"spectrum I\" [900 1 1000 1]")->lights.at(0)->power(1)));
    forgetWarnings();
    const auto line = loadWorldV4("LightSource \"distant\" \"spectrum L\" [589.3 1]");
    EXPECT_EQ(warningCount(), 1);
    const Rgb sodium = line->lights.at(0)->sample(Vec3(0.f), Vec2(0.5f, 0.5f))->radiance;
    EXPECT_NEAR(0.2126f * sodium.x + 0.7152f * sodium.y + 0.0722f * sodium.z, 1, 1e-2f);
    EXPECT_GT(sodium.x, sodium.y);
    EXPECT_EQ(sodium.z, 0);
}

// In pbrt-v3, what a spectrum is at its ends goes on.
TEST(LightSpectraOfV3, GoOnBeyondTheirEnds) {
    const auto radiance = [](const char* pairs) {
        return loadWorld(std::string("LightSource \"infinite\" \"spectrum L\" ") + pairs)
            ->lights.at(0)
            ->escaped(Vec3(0.f), Vec3(0, 0, 1));
    };
    EXPECT_EQ(radiance("[500 2 600 2]"), radiance("[300 2 900 2]"));
}

}  // namespace
}  // namespace drc::pbrt
