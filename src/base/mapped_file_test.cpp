#include "base/mapped_file.h"

#include <gmock/gmock.h>

#include <fstream>

#include "base/folder_testing.h"

namespace drc {
namespace {

class MappedFiles : public FolderTest {};

TEST_F(MappedFiles, HaveTheFilesBytes) {
    const std::string content("a\0b\n", 4);
    std::ofstream(path("file"), std::ios::binary) << content;
    MappedFile file(path("file"));
    EXPECT_EQ(file.bytes(), content);
    const MappedFile moved(std::move(file));
    EXPECT_EQ(moved.bytes(), content);
}

TEST_F(MappedFiles, MayBeEmpty) {
    std::ofstream(path("empty"));
    EXPECT_TRUE(MappedFile(path("empty")).bytes().empty());
}

TEST_F(MappedFiles, MissingOrNoFileIsAnErrorWithItsName) {
    EXPECT_EQ(errorOf([&] { MappedFile file(path("missing")); }),
              path("missing") + ": cannot open: No such file or directory");
    EXPECT_EQ(errorOf([&] { MappedFile file(path("")); }), path("") + ": not a regular file");
}

}  // namespace
}  // namespace drc
