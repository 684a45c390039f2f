#include "neural/safetensors.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

class Safetensors : public FolderTest {
  protected:
    void writeRaw(const std::string& header, size_t dataBytes, int64_t claimedHeader = -1) {
        std::ofstream out(path_, std::ios::binary);
        const uint64_t n = claimedHeader < 0 ? header.size() : uint64_t(claimedHeader);
        out.write(reinterpret_cast<const char*>(&n), 8);
        out << header << std::string(dataBytes, '\0');
    }
    std::string error() {
        const std::string text = errorOf([&] { SafetensorsFile file(path_); });
        EXPECT_EQ(text.find(path_), 0u) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        return text;
    }

    const std::string path_ = path("a.safetensors");
};

TEST_F(Safetensors, RoundTrip) {
    const std::vector<float> a{0, 1, -2.5f, 65504, 1e-8f, 3.14159265f};
    writeSafetensors(path_,
                     {{"a", {2, 3}, a.data()}, {"h", {6}, a.data(), DType::F16}, {"b", {3, 2}, a.data(), DType::BF16}},
                     {{"format", "test \"quoted\""}});
    SafetensorsFile file(path_);
    EXPECT_EQ(file.metadata("format", ""), "test \"quoted\"");
    EXPECT_EQ(file.metadata("none", "x"), "x");
    EXPECT_EQ(file.tensor("a").shape, (std::vector<int64_t>{2, 3}));
    EXPECT_EQ(file.tensor("a").toFloat(), a);
    const auto h = file.tensor("h").toFloat(), b = file.tensor("b").toFloat();
    for (size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(h[i], a[i], std::abs(a[i]) * 0.0005 + 3e-8);
        EXPECT_NEAR(b[i], a[i], std::abs(a[i]) * 0.004);
    }
    float two[2];
    file.tensor("h").toFloat(1, 2, two);
    EXPECT_EQ(two[1], -2.5f);
    EXPECT_THROW(file.tensor("h").toFloat(5, 2, two), Error);
    EXPECT_THROW(file.tensor("zzz"), Error);
    const SafetensorsFile moved(std::move(file));
    EXPECT_EQ(moved.tensor("a").toFloat(), a);
}

TEST_F(Safetensors, Bf16RoundsAndKeepsSpecialValues) {
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<float> a{1.00390625f, 1.01171875f, inf, std::nanf(""), 3.4e38f};
    writeSafetensors(path_, {{"b", {5}, a.data(), DType::BF16}}, {});
    const auto b = SafetensorsFile(path_).tensor("b").toFloat();
    EXPECT_EQ(b[0], 1.f);        // a tie, rounded to even
    EXPECT_EQ(b[1], 1.015625f);  // a tie, rounded to even
    EXPECT_EQ(b[2], inf);
    EXPECT_TRUE(std::isnan(b[3]));
    EXPECT_EQ(b[4], inf);
}

TEST_F(Safetensors, HashTellsContents) {
    std::vector<float> a(100, 1.f);
    writeSafetensors(path_, {{"a", {100}, a.data()}}, {});
    const std::string first = SafetensorsFile(path_).contentHash();
    EXPECT_EQ(first, SafetensorsFile(path_).contentHash());
    a[99] = 2;
    writeSafetensors(path_, {{"a", {100}, a.data()}}, {});
    EXPECT_NE(first, SafetensorsFile(path_).contentHash());
}

TEST_F(Safetensors, BadFiles) {
    writeRaw("{}", 0, int64_t(1) << 62);
    EXPECT_THAT(error(), HasSubstr("a header of"));
    writeRaw("{}", 0, 100);
    EXPECT_THAT(error(), HasSubstr("truncated"));
    const struct {
        std::string header;
        size_t dataBytes;
        const char* complaint;
    } kAll[] = {
        {"[1]", 0, "not a JSON object"},
        {"{\"a\"", 0, "not a JSON object"},
        {R"({"a":{"dtype":"I64","shape":[1],"data_offsets":[0,8]}})", 8, "dtype 'I64'"},
        {R"({"a":{"dtype":"F32","shape":[3],"data_offsets":[0,8]}})", 8, "disagree"},
        {R"({"a":{"dtype":"F32","shape":[4611686018427387904,4],"data_offsets":[0,0]}})", 0, "too large"},
        {R"({"a":{"dtype":"F32","shape":[-1],"data_offsets":[0,8]}})", 8, "not a whole number"},
        {R"({"a":{"dtype":"F32","shape":[2],"data_offsets":[0,8]},)"
         R"("b":{"dtype":"F32","shape":[2],"data_offsets":[4,12]}})",
         12, "overlap"},
        {R"({"a":{"dtype":"F32","shape":[2],"data_offsets":[4,12]}})", 12, "hole"},
        {R"({"a":{"dtype":"F32","shape":[2],"data_offsets":[0,8]}})", 9, "after the last tensor"},
        {R"({"a":{"dtype":"F32","shape":[2],"data_offsets":[8,0]}})", 8, "wrong order"},
        {R"({"a":5})", 0, "not an object"},
        {R"({"__metadata__":{"k":5}})", 0, "not a string"},
    };
    for (const auto& [header, dataBytes, complaint] : kAll) {
        writeRaw(header, dataBytes);
        EXPECT_THAT(error(), HasSubstr(complaint)) << header;
    }
}

TEST_F(Safetensors, CannotWrite) { EXPECT_THROW(writeSafetensors("/nonexistent/x.safetensors", {}, {}), Error); }

}  // namespace
}  // namespace drc
