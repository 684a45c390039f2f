// What the tests of `drc image` share.
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/command.h"
#include "app/command_testing.h"
#include "base/folder_testing.h"
#include "base/log.h"
#include "image/image_io.h"
#include "image/picture_file.h"

namespace drc {

class ImageCommandFolder : public FolderTest {
  protected:
    // What `drc image ...` prints.
    static std::string run(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "image");
        return test::outputOf(addImageCommand, std::move(arguments));
    }
    // Renders are made with --quiet, which would hold for the tests that follow.
    void TearDown() override { setLogLevel(LogLevel::Normal); }
    // The Error that it ends with, which must have left no file `out`.
    std::string complaint(const std::vector<std::string>& arguments, const std::string& out = "") const {
        const std::string text = errorOf([&] { run(arguments); });
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        EXPECT_FALSE(!out.empty() && std::filesystem::exists(path(out))) << text;
        return text;
    }
};

}  // namespace drc
