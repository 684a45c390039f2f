#include "base/state_file.h"

#include <gmock/gmock.h>

#include <array>
#include <vector>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class StateFile : public FolderTest {
  protected:
    StateReader open(const std::string& name, const std::string& header = "number 1 of a room") const {
        return StateReader(path(name), "number", header);
    }
    void save(const std::string& name, size_t count) const {
        StateWriter file(path(name), "number 1 of a room");
        file.value(uint16_t(0x1234));
        file.value(-2.5);
        std::vector<float> many(count);
        for (size_t i = 0; i < count; ++i) many[i] = float(i);
        file.values(std::span<const float>(many));
        file.commit();
    }
};

// Of sizes within, at, and beyond the borders of the pieces that are written at once.
TEST_F(StateFile, ValuesComeBackInTheirOrder) {
    for (const size_t count : {0, 1, 3, 16'381, 16'382, 40'000}) {
        save("a", count);
        StateReader file = open("a");
        EXPECT_EQ(file.value<uint16_t>(), 0x1234);
        EXPECT_EQ(file.value<double>(), -2.5);
        EXPECT_EQ(file.remaining(), count * sizeof(float));
        std::vector<float> many(count);
        file.values(std::span(many));
        for (size_t i = 0; i < count; ++i) ASSERT_EQ(many[i], float(i));
        file.finish();
        EXPECT_THAT(errorOf([&] { file.value<uint8_t>(); }), HasSubstr("a: the file is damaged: it ends too early"));
    }
}

// The format does not depend on what wrote it.
TEST_F(StateFile, BytesAreThoseOfTheFormat) {
    StateWriter file(path("a"), "x");
    file.value(uint8_t(1));
    file.value(uint32_t(0x04030201));
    file.value(1.f);
    file.commit();
    const std::string bytes = readFile(path("a"));
    EXPECT_EQ(bytes.size(), 2 + 9 + 8u);
    EXPECT_THAT(bytes, StartsWith(std::string("x\n\1\1\2\3\4\0\0\x80\x3f", 11)));
}

TEST_F(StateFile, DamageIsFoundBeforeAnythingIsRead) {
    save("a", 20'000);
    const std::string bytes = readFile(path("a"));
    for (size_t at = 0; at < bytes.size(); at += at < 60 || at + 20 > bytes.size() ? 1 : 997) {
        std::string flipped = bytes;
        flipped[at] = char(flipped[at] ^ 0x08);
        folder_.write("flipped", flipped);
        EXPECT_THAT(errorOf([&] { open("flipped"); }), StartsWith(path("flipped") + ": ")) << at;
        folder_.write("short", bytes.substr(0, at));
        EXPECT_THAT(errorOf([&] { open("short"); }), StartsWith(path("short") + ": ")) << at;
    }
    folder_.write("long", bytes + '\0');
    EXPECT_THAT(errorOf([&] { open("long"); }), HasSubstr("long: the file is damaged: its checksum is wrong"));
}

TEST_F(StateFile, ForeignFilesAreNamed) {
    save("a", 1);
    folder_.write("b", "P6 1 1");
    EXPECT_EQ(errorOf([&] { open("b"); }), path("b") + ": not a number");
    EXPECT_EQ(errorOf([&] { open("a", "number 1 of a hall"); }),
              path("a") + ": a number of another scene, other settings or another version");
    // A header that goes on differently is another one.
    EXPECT_THAT(errorOf([&] { open("a", "number 1 of a"); }), HasSubstr("another scene"));
    StateReader file = open("a");
    EXPECT_THAT(errorOf([&] { file.finish(); }), HasSubstr("a: the file is damaged: it has 14 bytes too many"));
}

TEST_F(StateFile, AFileIsReplacedWholeOrNotAtAll) {
    save("a", 3);
    const std::string before = readFile(path("a"));
    {
        StateWriter file(path("a"), "number 1 of a room");
        file.value(1);
    }
    EXPECT_EQ(readFile(path("a")), before);
    EXPECT_NE(errorOf([&] {
                  const FileSizeLimit full(1 << 16);
                  save("a", 100'000);
              }),
              "");
    EXPECT_EQ(readFile(path("a")), before);
}

}  // namespace
}  // namespace drc
