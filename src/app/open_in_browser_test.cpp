#include "app/open_in_browser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;
using testing::Not;

class OpenInBrowser : public FolderTest {
  protected:
    void SetUp() override {
        path_ = getenv("PATH") ? getenv("PATH") : "";
        temporary_ = getenv("TMPDIR") ? getenv("TMPDIR") : "";
        setenv("PATH", (dir_.string() + ":/usr/bin:/bin").c_str(), 1);
        setenv("TMPDIR", dir_.c_str(), 1);
    }
    void TearDown() override {
        setenv("PATH", path_.c_str(), 1);
        temporary_.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", temporary_.c_str(), 1);
    }
    // What a file has as soon as it is there; empty after five seconds.
    std::string textOf(const std::string& name) const {
        for (int i = 0; i < 500 && !std::filesystem::exists(path(name)); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        std::ifstream in(path(name));
        return {std::istreambuf_iterator<char>(in), {}};
    }

  private:
    std::string path_, temporary_;
};

TEST_F(OpenInBrowser, TheAddressStandsInAPageOfTheUsersAlone) {
    folder_.write("xdg-open", "#!/bin/sh\ncd " + dir_.string() +
                                  "\nstat -c %a \"$1\" \"$(dirname \"$1\")\" > modes\ncp \"$1\" page\n"
                                  "tr '\\0' ' ' < /proc/$$/cmdline > line.new\nmv line.new line\n");
    chmod(path("xdg-open").c_str(), 0700);
    openInBrowser("http://127.0.0.1:4711/0123456789abcdef/");
    EXPECT_THAT(textOf("line"), AllOf(HasSubstr("view.html"), Not(HasSubstr("0123456789abcdef"))));
    EXPECT_THAT(textOf("page"), HasSubstr("url=http://127.0.0.1:4711/0123456789abcdef/\""));
    EXPECT_EQ(textOf("modes"), "600\n700\n");
    // The child is waited for: no zombie stays.
    for (int i = 0; i < 500 && (waitpid(-1, nullptr, WNOHANG) == 0); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
}

TEST_F(OpenInBrowser, WithoutXdgOpenThePageIsGone) {
    setenv("PATH", dir_.c_str(), 1);
    EXPECT_EQ(errorOf([] { openInBrowser("http://127.0.0.1:1/a/"); }), "there is no xdg-open");
    EXPECT_TRUE(std::filesystem::is_empty(dir_));
}

}  // namespace
}  // namespace drc
