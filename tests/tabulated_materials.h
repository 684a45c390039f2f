// Materials whose BSDF is a table in a file, which is written for the test, and the materials that they are tables of.
#pragma once
#include <string>

#include "base/folder_testing.h"
#include "pbrt/fourier_file_testing.h"
#include "pbrt/measured_file_testing.h"
#include "scene/lobes/lambert_reflection.h"
#include "scene/lobes/microfacet_reflection.h"
#include "scene/materials/conductor_textures.h"
#include "test_scenes.h"

namespace drc::test {

struct TabulatedMaterial {
    const char* name;
    bool v4;
    // Writes the file and returns the material that names it.
    std::string (*write)(const TemporaryFolder& folder);
    const char* same;  // the material that the table was made of
};

inline std::string fourierMaterial(const TemporaryFolder& folder, const FourierSeries& series) {
    return "Material \"fourier\" \"string bsdffile\" \"" + folder.write("table.bsdf", fourierFile(series)) + "\"";
}

inline const TabulatedMaterial kTabulatedMaterials[] = {
    {"FourierMatte", false,
     [](const TemporaryFolder& folder) {
         return fourierMaterial(folder,
                                fourierSeriesOfLobe(LambertReflection(Rgb(0.7f, 0.4f, 0.3f)), fourierCosines(8), 3));
     },
     R"(Material "matte" "rgb Kd" [0.7 0.4 0.3])"},
    {"FourierMetal", false,
     [](const TemporaryFolder& folder) {
         const MicrofacetReflection lobe(Rgb(1.f), TrowbridgeReitz(0.35f, 0.35f),
                                         Fresnel::conductor(kCopperEta, kCopperK));
         return fourierMaterial(folder, fourierSeriesOfLobe(lobe, fourierCosines(40), 3));
     },
     R"(Material "metal" "float roughness" 0.35 "bool remaproughness" "false")"},
    {"MeasuredMetal", true,
     [](const TemporaryFolder& folder) {
         const TrowbridgeReitz brushed(0.5f, 0.3f);
         const MicrofacetReflection lobe(Rgb(1.f), brushed, Fresnel::conductor(kCopperEta, kCopperK));
         const MeasuredData data = measuredDataOfLobe(lobe, brushed, {.theta = 16, .phi = 25});
         return "Material \"measured\" \"string filename\" \"" +
                folder.write("metal.bsdf", rgbMeasuredFile(data).file()) + "\"";
     },
     R"(Material "conductor" "float uroughness" 0.5 "float vroughness" 0.3 "bool remaproughness" false)"},
};
inline void PrintTo(const TabulatedMaterial& m, std::ostream* out) { *out << m.name; }

// The room of test_scenes.h with a material, in either dialect.
inline std::string roomWith(const TabulatedMaterial& m, const std::string& material, int width, int height) {
    const std::string text = room(material, width, height);
    return m.v4 ? inWordsOfV4(text) : text;
}

}  // namespace drc::test
