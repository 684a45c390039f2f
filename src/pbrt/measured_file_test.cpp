#include "pbrt/measured_file.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"
#include "base/log.h"
#include "pbrt/bsdf_files.h"
#include "pbrt/measured_file_testing.h"
#include "pbrt/spectrum.h"
#include "pbrt/test_scenes.h"
#include "scene/lobes/microfacet_reflection.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;
using testing::Not;

const TrowbridgeReitz kMicrofacets(0.4f, 0.4f);

MeasuredData small() {
    const MicrofacetReflection lobe(Rgb(0.9f, 0.5f, 0.2f), kMicrofacets, Fresnel::none());
    return test::measuredDataOfLobe(lobe, kMicrofacets, {.theta = 3, .phi = 1, .normals = 5, .light = 4});
}

class MeasuredFileTest : public FolderTest {
  protected:
    // The error for a file, without its name.
    std::string error(const std::string& bytes) const {
        const std::string file = folder_.write("a.bsdf", bytes), text = errorOf([&] { readMeasuredFile(file); });
        EXPECT_THAT(text, Not(HasSubstr("\n")));
        EXPECT_THAT(text, testing::StartsWith(file + ": the BSDF file "));
        return text.substr(std::min(text.size(), file.size() + 16));
    }
    // The error for the file of small() as changed.
    std::string errorWith(const std::function<void(MeasuredData&)>& change) const {
        MeasuredData d = small();
        change(d);
        return error(test::greyMeasuredFile(d).file());
    }
};

TEST_F(MeasuredFileTest, ReadsWhatIsThere) {
    const MeasuredData expected = small();
    const MeasuredData d = readMeasuredFile(folder_.write("a.bsdf", test::greyMeasuredFile(expected).file()));
    EXPECT_EQ(d.theta, expected.theta);
    EXPECT_EQ(d.phi, expected.phi);
    EXPECT_EQ(d.ndf, expected.ndf);
    EXPECT_EQ(d.sigma, expected.sigma);
    EXPECT_EQ(d.vndf, expected.vndf);
    EXPECT_EQ(d.luminance, expected.luminance);
    EXPECT_EQ(d.vndfGrid.width, 5);
    EXPECT_EQ(d.lightGrid.height, 4);
    EXPECT_TRUE(d.jacobian);
    ASSERT_EQ(d.colors.size(), expected.colors.size());
    for (size_t i = 0; i < d.colors.size(); ++i)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(d.colors[i][c], expected.colors[i].y, 1e-5f);
}

// As the spectra of other reflectances of pbrt-v4.
TEST_F(MeasuredFileTest, SpectraBecomeRgb) {
    const MeasuredData expected = small();
    const std::vector<float> wavelengths = {360, 420, 460, 500, 530, 560, 590, 640, 700, 800};
    const auto spectrum = [](const Rgb& color, float nm) { return nm < 490 ? color.z : nm < 580 ? color.y : color.x; };
    const MeasuredData d =
        readMeasuredFile(folder_.write("a.bsdf", test::measuredFile(expected, wavelengths, spectrum).file()));
    for (size_t i = 0; i < d.colors.size(); ++i) {
        std::vector<SpectrumSample> samples;
        for (const float nm : wavelengths) samples.push_back({nm, spectrum(expected.colors[i], nm)});
        const Rgb color = clampNonNegative(reflectanceToRgb(samples));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(d.colors[i][c], color[c], 1e-5f);
    }
}

TEST_F(MeasuredFileTest, Rgb) {
    const MeasuredData expected = small();
    const MeasuredData d = readMeasuredFile(folder_.write("a.bsdf", test::rgbMeasuredFile(expected).file()));
    EXPECT_EQ(d.colors, expected.colors);
}

// Wherever it is cut: within every field of the header and within the data.
TEST_F(MeasuredFileTest, CutShort) {
    const test::TensorWriter w = test::greyMeasuredFile(small());
    const std::string whole = w.file();
    for (size_t size = 0; size < whole.size(); size += size < w.headerSize() + 16 ? 1 : 61) {
        const std::string text = error(whole.substr(0, size));
        if (size < 12)
            EXPECT_THAT(text, HasSubstr("begin with 'tensor_file'")) << size;
        else
            EXPECT_THAT(text, HasSubstr("is cut short: ")) << size;
    }
    EXPECT_EQ(error(whole.substr(0, 13)), "is cut short: its version ends at byte 14, and it has 13");
    EXPECT_EQ(error(whole.substr(0, 19)), "is cut short: field 1 of 10 ends at byte 20, and it has 19");
}

TEST_F(MeasuredFileTest, HeaderFields) {
    const std::string whole = test::greyMeasuredFile(small()).file();
    const auto errorAt = [&](size_t offset, const std::string& bytes) {
        std::string changed = whole;
        changed.replace(offset, bytes.size(), bytes);
        return error(changed);
    };
    EXPECT_THAT(errorAt(12, "\2"), HasSubstr("has the version 2.0; only 1.0 is supported"));
    EXPECT_THAT(errorAt(14, "\xff\xff\xff\xff"), HasSubstr("is cut short"));
    EXPECT_THAT(errorAt(18, "\xff\xff"), HasSubstr("is cut short"));  // length of the first name, "description"
    EXPECT_THAT(errorAt(31, "\xff\xff"), HasSubstr("is cut short"));  // its dimensions
    EXPECT_THAT(errorAt(33, std::string(1, '\0')), HasSubstr("has a field 'description' of the unknown type 0"));
    EXPECT_THAT(errorAt(33, "\x0c"), HasSubstr("unknown type 12"));
    // Names are shown as they can be, in one line.
    EXPECT_THAT(errorAt(20, std::string("des\n\x1b[1mion\1\0\0", 14)),
                HasSubstr("has a field 'des??[1mion' of the unknown"));
    EXPECT_THAT(errorAt(34, "\xff\xff\xff\xff\xff\xff\xff\xff"), HasSubstr("does not fit into its"));  // its offset
    EXPECT_THAT(errorAt(42, "\xff\xff\xff\xff\xff\xff\xff\x7f"), HasSubstr("does not fit into its"));  // its size
}

TEST_F(MeasuredFileTest, HostileSizes) {
    // Products of sizes that overflow, and that are zero.
    for (const std::vector<uint64_t>& shape :
         {std::vector<uint64_t>{1ull << 32, 1ull << 32, 1, 1}, {1ull << 63, 2, 1, 1}, {0, 1ull << 60, 1ull << 60, 3}}) {
        test::TensorWriter w;
        w.add("vndf", shape, std::vector<float>(2));
        EXPECT_THAT(error(w.file()), testing::AnyOf(HasSubstr("does not fit"), HasSubstr("has no field")));
    }
    EXPECT_THAT(errorWith([](MeasuredData& d) {
                    d.ndfGrid = {1, 3};
                    d.ndf.resize(3);
                }),
                HasSubstr("has a field 'ndf' with tables of 3 x 1 values; both must be 2 to"));
}

TEST_F(MeasuredFileTest, WhatDoesNotFitTogether) {
    EXPECT_THAT(errorWith([](MeasuredData& d) {
                    d.theta = {0, 1, 1};
                }),
                HasSubstr("has values of 'theta_i' that do not ascend: 1 (number 2) after 1"));
    EXPECT_THAT(errorWith([](MeasuredData& d) { d.theta = {0, 45, 80}; }), HasSubstr("must be radians"));
    EXPECT_THAT(errorWith([](MeasuredData& d) {
                    d.phi = {0, std::nanf("")};
                }),
                HasSubstr("has a value in 'phi_i' (number 1) that is not finite"));
    EXPECT_THAT(errorWith([](MeasuredData& d) { d.vndf[7] = -1; }),
                HasSubstr("has a negative value in 'vndf' (number 7)"));
    EXPECT_THAT(errorWith([](MeasuredData& d) { d.sigma[3] = HUGE_VALF; }),
                HasSubstr("has a value in 'sigma' (number 3) that is not finite"));
    EXPECT_THAT(errorWith([](MeasuredData& d) { d.colors[2].y = std::nanf(""); }),
                HasSubstr("has a value in 'spectra' (number 2) that is not finite"));
    const MeasuredData d = small();
    const auto without = [&](const std::string& name) {
        std::string bytes = test::greyMeasuredFile(d).file();
        bytes.replace(bytes.find(name), 1, "X");
        return error(bytes);
    };
    for (const char* name : {"theta_i", "phi_i", "ndf", "sigma", "luminance", "spectra", "wavelengths", "jacobian"})
        EXPECT_THAT(without(name), HasSubstr("has no field '" + std::string(name) + "'"));
    test::TensorWriter w = test::measuredFields(d);
    w.add("wavelengths", {2}, std::vector<float>{400, 700});
    w.add("spectra", {1, 3, 3, 4, 4}, std::vector<float>(144));
    EXPECT_THAT(error(w.file()), HasSubstr("has 2 wavelengths for spectra of 3"));
    w = test::measuredFields(d);
    w.add("wavelengths", {2}, std::vector<float>{400, 700});
    w.add("spectra", {1, 3, 2, 4, 3}, std::vector<float>(72));
    EXPECT_THAT(error(w.file()),
                HasSubstr("has a field 'spectra' with tables of 4 x 3 values, and a 'luminance' of 4 x 4"));
    w = test::measuredFields(d);
    w.add("rgb", {1, 2, 3, 4, 4}, std::vector<float>(96));
    EXPECT_THAT(error(w.file()),
                HasSubstr("has a field 'rgb' of 1 x 2 x 3 x 4 x 4 values for 1 azimuths and 3 zenith"));
    w = test::measuredFields(d);
    w.add("rgb", {1, 3, 3, 4, 4}, 1, std::string(144, 'x'));
    EXPECT_THAT(error(w.file()), HasSubstr("has a field 'rgb' of 5 dimensions and type uint8, not of 5 and float32"));
    w.add("ndf", {1}, std::vector<float>(1));
    EXPECT_THAT(error(w.file()), HasSubstr("has two fields 'ndf'"));
}

TEST_F(MeasuredFileTest, Material) {
    const std::string file = folder_.write("a.bsdf", test::greyMeasuredFile(small()).file());
    const std::string triangle =
        "\nShape \"trianglemesh\" \"integer indices\" [0 1 2] \"point3 P\" [0 0 0  1 0 0  0 1 0]\n";
    const std::string height = "Texture \"height\" \"float\" \"constant\" \"float value\" .1\n";
    forgetWarnings();
    const auto scene = loadWorldV4(
        height + "Material \"measured\" \"string filename\" \"a.bsdf\" \"texture displacement\" \"height\"" + triangle,
        folder_.path());
    EXPECT_EQ(warningCount(), 0);
    const Material& material = *scene->primitives.at(0).material;
    EXPECT_NE(material.relief().heights, nullptr);
    EXPECT_TRUE(material.isConstant());
    EXPECT_EQ(material.maxLobes(), 1);
    Bsdf bsdf(Frame(), Vec3(0, 0, 1));
    material.addLobes({}, Rgb(0.5f), bsdf);
    EXPECT_EQ(bsdf.size(), 1);
    EXPECT_GT(bsdf.f(Vec3(0, 0, 1), Vec3(0, 0, 1)).x, 0.05f);
    EXPECT_THAT(errorOfWorldV4("Material \"measured\""), HasSubstr("needs the parameter \"string filename\""));
    EXPECT_THAT(errorOfWorldV4("Material \"measured\" \"string filename\" \"none.bsdf\""),
                HasSubstr("s.pbrt:2:39: cannot find the BSDF file 'none.bsdf'"));
    BsdfFiles files;
    EXPECT_EQ(files.measured(file, {}), files.measured(file, {}));
}

}  // namespace
}  // namespace drc::pbrt
