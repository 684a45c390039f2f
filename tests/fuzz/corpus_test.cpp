// The seeds of the fuzzers and everything that they found: each file must either be read or be refused with an Error.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/targets.h"

namespace drc::fuzz {
namespace {

class Corpus : public testing::TestWithParam<std::pair<const char*, void (*)(std::string_view)>> {};

TEST_P(Corpus, IsReadOrRefused) {
    const auto [name, target] = GetParam();
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(DRC_SOURCE_DIR) / "tests/fuzz/corpus" / name)) {
        SCOPED_TRACE(entry.path().filename().string());
        std::ifstream in(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(in), {}};
        EXPECT_NO_THROW(target(bytes));
        ++files;
    }
    EXPECT_GE(files, 3);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus,
                         testing::Values(std::pair("tokenizer", &tokenizer), std::pair("parser", &parser),
                                         std::pair("ply", &ply), std::pair("fourier", &fourier),
                                         std::pair("measured", &measured), std::pair("safetensors", &safetensors),
                                         std::pair("examples", &examples), std::pair("tga", &tga),
                                         std::pair("hdr", &hdr), std::pair("picture", &picture),
                                         std::pair("view", &view)),
                         [](const auto& tested) { return std::string(tested.param.first); });

TEST(Fuzz, ScenesOpenNoFiles) {
    EXPECT_EQ(confined("Include \"/dev/zero\" Include \"../a\" Include \"\\\n/etc/passwd\""),
              "Include \"_dev_zero\" Include \".._a\" Include \"\\\n_etc_passwd\"");
}

}  // namespace
}  // namespace drc::fuzz
