// For tests that write files: a folder of their own, gone when the test ends, and what an error says.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/error.h"

namespace drc {

class FolderTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "drc-test-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        dir_ = name;
    }
    void TearDown() override { std::filesystem::remove_all(dir_); }
    std::string path(const std::string& name) const { return (dir_ / name).string(); }

    // What the Error says that f throws; empty if it throws none.
    template <typename F>
    static std::string errorOf(F f) {
        try {
            f();
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    }
    std::filesystem::path dir_;
};

}  // namespace drc
