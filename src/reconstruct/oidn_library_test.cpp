#include "reconstruct/oidn_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kName = "libOpenImageDenoise.so.2";

// A machine in a temporary folder, without a library and without Python.
class OidnLibraryTest : public FolderTest {
  protected:
    void SetUp() override {
        search_.program = path("drc/build/release");
        search_.root = path("");
        search_.home = path("home/me");
        search_.path = path("usr/bin") + ":" + path("opt/bin") + "::relative/bin";
    }
    // Makes an empty file of the library's name in a folder.
    std::string library(const std::string& folder, const std::string& name = kName) const {
        return folder_.write(folder + "/" + name, "");
    }
    void link(const std::string& target, const std::string& from) const {
        fs::create_directories(fs::path(path(from)).parent_path());
        fs::create_symlink(path(target), path(from));
    }
    // What is found besides the names that the system's loader looks up.
    std::vector<std::string> files() const {
        std::vector<std::string> found = findOidn(search_).candidates;
        std::erase_if(found, [](const std::string& name) { return name.find('/') == std::string::npos; });
        return found;
    }

    OidnSearch search_;
};

TEST_F(OidnLibraryTest, WithoutAnyTheSystemsLoaderIsAsked) {
    const OidnLibraries found = findOidn(search_);
    EXPECT_EQ(found.namedBy, "");
    EXPECT_THAT(found.candidates, ElementsAre(kName, "libOpenImageDenoise.so.1", "libOpenImageDenoise.so"));
}

TEST_F(OidnLibraryTest, TheOneBesideTheProgramIsFirstAndPythonsAreLast) {
    const std::string python = library("usr/lib/python3/dist-packages/pyoidn/oidn/lib");
    const std::string installed = library("drc/build/lib/drc/oidn"), own = library("drc/build/release/oidn");
    EXPECT_THAT(findOidn(search_).candidates,
                ElementsAre(own, installed, kName, "libOpenImageDenoise.so.1", "libOpenImageDenoise.so", python));
}

TEST_F(OidnLibraryTest, FindsThePackagesOfEveryPython) {
    const std::string system = library("usr/lib/python3/dist-packages/pyoidn/oidn/lib"),
                      local = library("usr/local/lib/python3.11/dist-packages/pyoidn/oidn/lib"),
                      user = library("home/me/.local/lib/python3.11/site-packages/pyoidn/oidn/lib"),
                      onPath = library("opt/lib/python3.12/site-packages/pyoidn/oidn/lib"),
                      active = library("venv/lib/python3.9/site-packages/pyoidn/oidn/lib"),
                      blender = library("venv/lib/python3.9/site-packages/bpy/lib");
    library("else/lib/python3.9/site-packages/pyoidn/oidn/lib");
    EXPECT_THAT(files(), ElementsAre(user, local, system));
    folder_.write("opt/bin/python3", "");
    EXPECT_THAT(files(), ElementsAre(onPath, user, local, system));
    search_.virtualEnv = path("venv");
    EXPECT_THAT(files(), ElementsAre(active, onPath, user, local, system, blender));
}

// A virtual environment's python3 is a link; pyenv's is a script beside which nothing lies.
TEST_F(OidnLibraryTest, FindsThePythonBehindLinksAndShims) {
    const std::string base = library("base/lib/python3.11/site-packages/pyoidn/oidn/lib"),
                      version = library("pyenv/versions/3.12.1/lib/python3.12/site-packages/pyoidn/oidn/lib");
    folder_.write("base/bin/python3.11", "");
    link("base/bin/python3.11", "opt/bin/python3");
    EXPECT_THAT(files(), ElementsAre(base));
    folder_.write("pyenv/shims/python3", "");
    search_.path += ":" + path("pyenv/shims");
    EXPECT_THAT(files(), ElementsAre(base, version));
}

TEST_F(OidnLibraryTest, OneThatIsNamedIsTheOnlyOne) {
    library("drc/build/release/oidn");
    const std::string file = library("mine", "my.so"), unpacked = library("oidn-2.4/lib");
    search_.named = path("oidn-2.4");
    EXPECT_THAT(findOidn(search_).candidates, ElementsAre(unpacked));
    EXPECT_EQ(findOidn(search_).namedBy, "DRC_OIDN " + path("oidn-2.4"));
    search_.named = path("oidn-2.4/lib");
    EXPECT_THAT(findOidn(search_).candidates, ElementsAre(unpacked));
    search_.option = file;
    EXPECT_THAT(findOidn(search_).candidates, ElementsAre(file));
    EXPECT_EQ(findOidn(search_).namedBy, "--oidn-library " + file);
    search_.option = "libOther.so.3";  // as the system's loader takes it
    EXPECT_THAT(findOidn(search_).candidates, ElementsAre("libOther.so.3"));
}

TEST_F(OidnLibraryTest, OneThatIsNamedMustExist) {
    library("drc/build/release/oidn");
    fs::create_directories(path("empty"));
    search_.named = path("none/lib.so");
    EXPECT_EQ(errorOf([&] { findOidn(search_); }), "DRC_OIDN " + search_.named + ": there is no such file or folder");
    search_.named = path("empty");
    EXPECT_EQ(errorOf([&] { findOidn(search_); }),
              "DRC_OIDN " + search_.named + ": there is no libOpenImageDenoise.so.2 in this folder");
    search_.option = path("nothing.so");
    EXPECT_THAT(errorOf([&] { findOidn(search_); }), AllOf(HasSubstr("--oidn-library"), Not(HasSubstr("DRC_OIDN"))));
}

// The file system's oddities end no search: a file where a folder is expected, a link to itself.
TEST_F(OidnLibraryTest, OddFilesAreSkipped) {
    folder_.write("usr/lib", "");
    folder_.write("opt/bin/python3", "");
    fs::create_directories(path("opt/lib/python3.11/site-packages/bpy/lib") + "/" + kName);
    link("home/me/.local", "home/me/.local");
    EXPECT_THAT(files(), ElementsAre());
}

TEST(OidnSearch, OfTheProcessKnowsWhereTheProgramIs) {
    const OidnSearch search = OidnSearch::ofProcess("here.so");
    EXPECT_EQ(search.option, "here.so");
    EXPECT_TRUE(fs::exists(search.program / "render_tests"));
    EXPECT_EQ(search.root, "/");
}

}  // namespace
}  // namespace drc
