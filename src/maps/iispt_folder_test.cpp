#include "maps/iispt_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "maps/example_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const MapLayout kLayout(Projection::LatLong, 8);

class IisptFolders : public FolderTest {
  protected:
    IisptFolders() {
        header_.scene = "room";
        header_.layout = kLayout;
        header_.targetSamples = 16;
        header_.viewpoints = 3;
    }
    // All normals face the origin, so that reading does not flip them.
    static TrainingExample example(unsigned seed, int x, int y) {
        TrainingExample e = randomExample(kLayout, 1, seed);
        e.film = Vec2(float(x) + 0.3f, float(y) + 0.9f);
        for (int i = 0; i < kLayout.texels(); ++i) {
            const Vec3 d = kLayout.direction(i % 8, i / 8, Vec2(0.5f, 0.5f));
            for (size_t c = 0; c < 3; ++c) e.inputs[0].normal[c * 64 + size_t(i)] = -d[int(c)];
        }
        e.inputs[0].distance[9] = -1;
        for (size_t c = 0; c < 3; ++c) e.inputs[0].normal[c * 64 + 9] = 0;
        return e;
    }
    void write() const {
        const IisptWriter writer(folder(), header_);
        writer.write(example(1, 12, 5));
        writer.write(example(2, 3, 40));
        writer.write(example(3, 4, 5));
    }
    std::string folder() const { return path("room"); }
    std::string file(const char* name) const { return folder() + "/" + name; }
    static float floatAt(const std::string& bytes, size_t at) {
        float value;
        std::memcpy(&value, bytes.data() + at, sizeof(value));
        return value;
    }

    ShardHeader header_;
};

TEST(IisptNames, AreTold) {
    for (const char* good : {"d_0_0.pfm", "n_12_345.pfm", "z_1_2.pfm", "p_1_2.pfm"}) EXPECT_TRUE(isIisptFile(good));
    for (const char* bad : {"", "d_.pfm", "d_1.pfm", "d_1_.pfm", "x_1_2.pfm", "d_1_2.exr", "d_1_2_3.pfm", "d_a_2.pfm",
                            "d__1_2.pfm", "d_99999999999_2.pfm", "train.json"})
        EXPECT_FALSE(isIisptFile(bad)) << bad;
}

TEST_F(IisptFolders, KeepWhatIsWritten) {
    write();
    const IisptFolder examples(folder());
    EXPECT_EQ(examples.damage(), "");
    EXPECT_EQ(examples.scene(), "room");
    EXPECT_EQ(examples.inputs(), 1);
    EXPECT_EQ(examples.layout().projection(), Projection::LatLong);
    EXPECT_EQ(examples.layout().size(), 8);
    ASSERT_EQ(examples.count(), 3);
    const TrainingExample expected[] = {example(3, 4, 5), example(1, 12, 5), example(2, 3, 40)};
    TrainingExample got;
    for (int i = 0; i < 3; ++i) {
        examples.load(i, 0, 1, got);
        EXPECT_EQ(got.film, Vec2(std::floor(expected[i].film.x) + 0.5f, std::floor(expected[i].film.y) + 0.5f));
        EXPECT_EQ(got.inputs[0].radiance, expected[i].inputs[0].radiance);
        EXPECT_EQ(got.inputs[0].normal, expected[i].inputs[0].normal);
        EXPECT_EQ(got.inputs[0].distance, expected[i].inputs[0].distance);
        EXPECT_EQ(got.target, expected[i].target);
        EXPECT_TRUE(got.targetDeviation.empty());
    }
    EXPECT_EQ(openExamples(folder())->contentHash(), examples.contentHash());
    EXPECT_EQ(findExamples({path(".")}).size(), 1u);
}

// As programs in other languages read PFM: the file begins with the image's bottom row, and channels are interleaved.
TEST_F(IisptFolders, HaveTheAuthorsOrderOfNumbers) {
    write();
    const TrainingExample e = example(1, 12, 5);
    const std::string light = readFile(file("d_12_5.pfm")), distance = readFile(file("z_12_5.pfm"));
    EXPECT_THAT(light, StartsWith("PF\n8 8\n-1\n"));
    EXPECT_THAT(distance, StartsWith("Pf\n8 8\n-1\n"));
    ASSERT_EQ(light.size(), 10u + 64 * 12);
    ASSERT_EQ(distance.size(), 10u + 64 * 4);
    for (size_t row : {0u, 3u, 7u})
        for (size_t column : {0u, 5u}) {
            const size_t place = (7 - row) * 8 + column, texel = row * 8 + column;
            EXPECT_EQ(floatAt(distance, 10 + 4 * place), e.inputs[0].distance[texel]);
            for (size_t c = 0; c < 3; ++c)
                EXPECT_EQ(floatAt(light, 10 + 4 * (3 * place + c)), e.inputs[0].radiance[c * 64 + texel]);
        }
    EXPECT_THAT(readFile(file("train.json")),
                StartsWith(R"({"normalization_intensity":0.0,"normalization_distance":0.0,"drc":{"scene":"room",)"));
}

TEST_F(IisptFolders, WithTheWrongByteOrderNamedAreUnderstood) {
    write();
    const std::string hash = IisptFolder(folder()).contentHash();
    for (const char kind : {'d', 'n', 'z', 'p'}) {
        const std::string name = file((std::string(1, kind) + "_12_5.pfm").c_str());
        std::string bytes = readFile(name);
        bytes.replace(bytes.find("-1\n"), 3, "1\n");
        writeFileAtomically(name, bytes);
    }
    const IisptFolder examples(folder());
    EXPECT_EQ(examples.damage(), "");
    EXPECT_NE(examples.contentHash(), hash);
    TrainingExample got;
    examples.load(1, 0, 1, got);
    EXPECT_EQ(got.inputs[0].radiance, example(1, 12, 5).inputs[0].radiance);
    EXPECT_EQ(got.inputs[0].normal, example(1, 12, 5).inputs[0].normal);
    EXPECT_EQ(got.inputs[0].distance, example(1, 12, 5).inputs[0].distance);
    EXPECT_EQ(got.target, example(1, 12, 5).target);
}

TEST_F(IisptFolders, NormalsThatFaceAwayAreTurned) {
    const IisptWriter writer(folder(), header_);
    TrainingExample e = example(1, 12, 5);
    for (const size_t texel : {0u, 17u, 63u})
        for (size_t c = 0; c < 3; ++c) e.inputs[0].normal[c * 64 + texel] *= -1;
    writer.write(e);
    TrainingExample got;
    IisptFolder(folder()).load(0, 0, 1, got);
    EXPECT_EQ(got.inputs[0].normal, example(1, 12, 5).inputs[0].normal);
}

TEST_F(IisptFolders, LeaveOutWhatIsIncompleteOrDamaged) {
    write();
    std::filesystem::remove(file("n_3_40.pfm"));
    {
        const IisptFolder examples(folder());
        EXPECT_EQ(examples.count(), 2);
        EXPECT_EQ(examples.damage(),
                  folder() + ": 1 viewpoints lack some of their files d, n, z, p; 2 examples are usable");
    }
    writeFileAtomically(file("z_12_5.pfm"), readFile(file("z_12_5.pfm")).substr(0, 100));
    {
        const IisptFolder examples(folder());
        EXPECT_EQ(examples.count(), 1);
        EXPECT_THAT(examples.damage(), HasSubstr(", 1 are damaged; 1 examples are usable"));
    }
    std::filesystem::remove_all(folder());
    std::filesystem::create_directory(folder());
    EXPECT_THAT(errorOf([&] { IisptFolder{folder()}; }), StartsWith(folder() + ": no files d_X_Y.pfm"));
}

TEST_F(IisptFolders, OfOthersAreNotWrittenTo) {
    write();
    EXPECT_EQ(errorOf([&] { IisptWriter(folder(), header_); }), "");
    header_.targetSamples = 8;
    EXPECT_THAT(errorOf([&] { IisptWriter(folder(), header_); }), HasSubstr("made with --spp 16, not 8"));
    for (const char* info : {"{\"normalization_intensity\":0}", "nonsense"}) {
        writeFileAtomically(file("train.json"), info);
        EXPECT_THAT(errorOf([&] { IisptWriter(folder(), header_); }), HasSubstr("made by another program"));
    }
    std::filesystem::remove(file("train.json"));
    EXPECT_THAT(errorOf([&] { IisptWriter(folder(), header_); }), HasSubstr("made by another program"));
}

}  // namespace
}  // namespace drc
