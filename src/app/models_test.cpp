#include "app/models.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/folder_testing.h"

namespace drc {
namespace {

// These find what comes with the program, as the tests lie where the program does.
TEST(Models, AreFoundByNameAndByDefault) {
    ::unsetenv("DRC_WEIGHTS");
    const std::string found = findWeights("");
    EXPECT_TRUE(std::filesystem::exists(found)) << found;
    EXPECT_EQ(std::filesystem::path(found).stem(), kDefaultNetwork);
    EXPECT_EQ(findWeights(kDefaultNetwork), found);
    EXPECT_EQ(std::filesystem::path(findWeights("drc")).filename(), "drc.safetensors");
    ::setenv("DRC_WEIGHTS", "my/own.safetensors", 1);
    EXPECT_EQ(findWeights(""), "my/own.safetensors");
    EXPECT_EQ(findWeights(kDefaultNetwork), found);
    ::setenv("DRC_WEIGHTS", "drc-fats", 1);
    EXPECT_NE(errorOf([] { findWeights(""); }).find("DRC_WEIGHTS drc-fats: neither"), std::string::npos);
    ::unsetenv("DRC_WEIGHTS");
}

TEST(Models, FilesAreTakenAsTheyAreNamed) {
    for (const char* path : {"somewhere/drc", "drc.safetensors", "./drc"}) EXPECT_EQ(findWeights(path), path);
}

TEST(Models, WhatIsNeitherIsRefusedWithTheNamesThatThereAre) {
    EXPECT_NE(errorOf([] {
                  findWeights("drc-fats");
              }).find("--weights drc-fats: neither a file nor a network that comes with the program (drc"),
              std::string::npos)
        << errorOf([] { findWeights("drc-fats"); });
}

}  // namespace
}  // namespace drc
