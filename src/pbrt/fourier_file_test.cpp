#include "pbrt/fourier_file.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"
#include "base/log.h"
#include "pbrt/bsdf_files.h"
#include "pbrt/fourier_file_testing.h"
#include "pbrt/test_scenes.h"
#include "scene/lobes/lambert_reflection.h"

namespace drc::pbrt {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

FourierSeries lambert() {
    return test::fourierSeriesOfLobe(LambertReflection(Rgb(0.8f, 0.5f, 0.2f)), test::fourierCosines(4), 3, 1.25f);
}

class FourierFileTest : public FolderTest {
  protected:
    // The error for a file, without its name.
    std::string error(const std::string& bytes) const {
        const std::string file = folder_.write("a.bsdf", bytes), text = errorOf([&] { readFourierFile(file); });
        EXPECT_THAT(text, Not(HasSubstr("\n")));
        EXPECT_THAT(text, testing::StartsWith(file + ": the BSDF file "));
        return text.substr(std::min(text.size(), file.size() + 16));
    }
    // The error for the file of lambert() with the four bytes at an offset replaced.
    template <typename T>
    std::string errorWith(size_t offset, T value) const {
        static_assert(sizeof(T) == 4);
        std::string bytes = whole_;
        std::memcpy(bytes.data() + offset, &value, 4);
        return error(bytes);
    }
    // Where the tables begin. There are eight cosines.
    static constexpr size_t kCosines = 64, kPairs = kCosines + 4 * 8 + 4 * 64, kCoefficients = kPairs + 8 * 64;
    const std::string whole_ = test::fourierFile(lambert());
};

TEST_F(FourierFileTest, ReadsWhatIsThere) {
    const FourierSeries expected = lambert(), s = readFourierFile(folder_.write("a.bsdf", whole_));
    EXPECT_EQ(s.cosines, expected.cosines);
    EXPECT_EQ(s.orders, expected.orders);
    EXPECT_EQ(s.coefficients, expected.coefficients);
    for (size_t i = 0; i < s.orders.size(); ++i) {
        if (s.orders[i] > 0) {
            EXPECT_EQ(s.offsets[i], expected.offsets[i]);
        }
    }
    EXPECT_EQ(s.channels, 3);
    EXPECT_EQ(s.eta, 1.25f);
    // What follows, such as metadata, does not matter.
    EXPECT_EQ(readFourierFile(folder_.write("a.bsdf", whole_ + "made by hand")).coefficients, expected.coefficients);
}

// Wherever it is cut: within every field of the header and within every table.
TEST_F(FourierFileTest, CutShort) {
    for (size_t size = 0; size < whole_.size(); ++size) {
        const std::string text = error(whole_.substr(0, size));
        if (size < 8)
            EXPECT_THAT(text, HasSubstr("begin with 'SCATFUN'")) << size;
        else if (size < kCosines)
            EXPECT_EQ(text, "is cut short: its header takes 64 bytes, and it has " + std::to_string(size));
        else
            EXPECT_EQ(text, "is cut short: its tables end at byte " + std::to_string(whole_.size()) + ", and it has " +
                                std::to_string(size));
    }
}

TEST_F(FourierFileTest, HeaderFields) {
    std::string other = whole_;
    other[7] = 2;
    EXPECT_THAT(error(other), HasSubstr("another kind"));
    EXPECT_THAT(errorWith(8, 2), HasSubstr("has the flags 2"));
    for (const int32_t n : {-1, 0, 1}) EXPECT_THAT(errorWith(12, n), EndsWith("it needs at least 2"));
    // Sizes that no memory could hold are sizes that the file does not have.
    for (const int32_t n : {9, 1 << 16, 0x7fffffff}) EXPECT_THAT(errorWith(12, n), HasSubstr("is cut short"));
    EXPECT_THAT(errorWith(16, -1), HasSubstr("has -1 coefficients"));
    EXPECT_THAT(errorWith(16, 0x7fffffff), HasSubstr("is cut short"));
    EXPECT_THAT(errorWith(16, 3), HasSubstr("outside of its 3 coefficients"));
    EXPECT_THAT(errorWith(20, -1), HasSubstr("up to -1 orders"));
    EXPECT_THAT(errorWith(20, 0), HasSubstr("of 1 orders; its header says at most 0"));
    for (const int32_t c : {0, 2, 4, -1}) EXPECT_THAT(errorWith(24, c), EndsWith("channels, not 1 or 3"));
    EXPECT_THAT(errorWith(28, 2), HasSubstr("has 2 basis functions"));
    for (const float eta : {0.f, -1.5f, std::nanf(""), HUGE_VALF})
        EXPECT_THAT(errorWith(44, eta), HasSubstr("index of refraction"));
}

TEST_F(FourierFileTest, Tables) {
    EXPECT_THAT(errorWith(kCosines, -0.9f), HasSubstr("they must run from -1 to 1"));
    EXPECT_THAT(errorWith(kCosines + 4, -1.f), HasSubstr("do not ascend: -1 (number 1) after -1"));
    EXPECT_THAT(errorWith(kCosines + 8, 0.f), HasSubstr("do not ascend"));  // three zeros
    EXPECT_THAT(errorWith(kCosines + 8, std::nanf("")), HasSubstr("(number 2) that is not finite"));
    // The first series that has a term is that of cosines -1 and 1 / 4.
    constexpr size_t kPair = kPairs + 8 * 5;
    EXPECT_THAT(errorWith(kPair, -1), HasSubstr("series (number 5) that lies outside of its"));
    EXPECT_THAT(errorWith(kPair, 0x7ffffff0), HasSubstr("outside of its"));
    EXPECT_THAT(errorWith(kPair + 4, 2), HasSubstr("of 2 orders; its header says at most 1"));
    EXPECT_THAT(errorWith(kPair + 4, -1), HasSubstr("of -1 orders"));
    EXPECT_THAT(errorWith(kCoefficients + 4, std::nanf("")), HasSubstr("coefficient (number 1) that is not finite"));
    // A small file whose series all share its coefficients.
    std::string bytes = whole_;
    const int32_t orders = int32_t(lambert().coefficients.size() / 3);
    std::memcpy(bytes.data() + 20, &orders, 4);
    for (size_t pair = 0; pair < 64; ++pair) {
        const int32_t place[2] = {0, orders};
        std::memcpy(bytes.data() + kPairs + 8 * pair, place, 8);
    }
    EXPECT_THAT(error(bytes), HasSubstr("which is too many for"));
}

TEST_F(FourierFileTest, NoFile) {
    EXPECT_THAT(errorOf([&] { readFourierFile(path("none.bsdf")); }), HasSubstr("cannot read BSDF file"));
    EXPECT_THAT(errorOf([&] { readFourierFile(folder_.path()); }), HasSubstr("cannot read BSDF file"));
}

const std::string kTriangle =
    "\nShape \"trianglemesh\" \"integer indices\" [0 1 2] \"point3 P\" [0 0 0  1 0 0  0 1 0]\n";

TEST_F(FourierFileTest, Material) {
    folder_.write("a.bsdf", whole_);
    const std::string height = "Texture \"height\" \"float\" \"constant\" \"float value\" .1\n";
    forgetWarnings();
    const auto scene = loadWorld(
        height + "Material \"fourier\" \"string bsdffile\" \"a.bsdf\" \"texture bumpmap\" \"height\"" + kTriangle,
        folder_.path());
    EXPECT_EQ(warningCount(), 0);
    const Material& material = *scene->primitives.at(0).material;
    EXPECT_NE(material.relief().heights, nullptr);
    EXPECT_TRUE(material.isConstant());
    Bsdf bsdf(Frame(), Vec3(0, 0, 1));
    material.addLobes({}, Rgb(0.5f), bsdf);
    EXPECT_EQ(bsdf.size(), 1);
    EXPECT_EQ(material.maxLobes(), 1);
    const Rgb f = bsdf.f(normalize(Vec3(1, 0, 1)), normalize(Vec3(0, 1, 2)));
    EXPECT_NEAR(f.x, 0.4f * kInvPi, 1e-4f);
    EXPECT_NEAR(f.y, 0.25f * kInvPi, 1e-4f);
    EXPECT_NEAR(f.z, 0.1f * kInvPi, 1e-4f);

    EXPECT_THAT(errorOfWorld("Material \"fourier\""), HasSubstr("needs the parameter \"string bsdffile\""));
    EXPECT_THAT(errorOfWorld("Material \"fourier\" \"string bsdffile\" \"none.bsdf\""),
                HasSubstr("s.pbrt:2:38: cannot find the BSDF file 'none.bsdf'"));
}

TEST_F(FourierFileTest, MaterialsShareATable) {
    const std::string file = folder_.write("a.bsdf", whole_);
    BsdfFiles files;
    const auto first = files.fourier(file, {});
    EXPECT_EQ(first, files.fourier(file, {}));
    EXPECT_NE(first, files.fourier(folder_.write("b.bsdf", whole_), {}));
}

}  // namespace
}  // namespace drc::pbrt
