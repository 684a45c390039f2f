#include "pbrt/mapped_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::EndsWith;

std::string errorOfFile(const std::string& path, uint64_t most = limits::kFileBytes) {
    return errorOf([&] { const MappedFile file(path, "scene file", most); });
}

TEST(MappedFile, HoldsTheFile) {
    const TemporaryFolder folder;
    EXPECT_EQ(MappedFile(folder.write("a", "text"), "file").text(), "text");
    EXPECT_EQ(MappedFile(folder.write("b", ""), "file").text(), "");
    // Small files are copied, and large ones mapped.
    for (const size_t size : {65535, 65536, 65537, 1 << 20}) {
        std::string text(size, 'a');
        for (size_t i = 0; i < size; ++i) text[i] = char('a' + i * 7 % 26);
        EXPECT_EQ(MappedFile(folder.write("c", text), "file").text(), text) << size;
    }
}

TEST(MappedFile, WhatIsNoFileIsRefusedAtOnce) {
    const TemporaryFolder folder;
    EXPECT_EQ(errorOfFile(folder.path()), "cannot read scene file '" + folder.path() + "': Is a directory");
    EXPECT_THAT(errorOfFile(folder.path() + "/absent"), EndsWith("absent': No such file or directory"));
    EXPECT_THAT(errorOfFile("/dev/zero"), EndsWith("/dev/zero': Invalid argument"));
    // A pipe to which nobody will ever write.
    const std::string pipe = folder.path() + "/pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(errorOfFile(pipe), EndsWith("pipe': Invalid argument"));
}

TEST(MappedFile, SparseFilesOfTerabytesAreRefused) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a", "12345");
    EXPECT_EQ(errorOfFile(path, 5), "");
    EXPECT_THAT(errorOfFile(path, 4), EndsWith("a': File too large"));
    std::error_code failed;
    std::filesystem::resize_file(path, limits::kFileBytes + 1, failed);
    if (failed) GTEST_SKIP() << "no sparse files here";
    EXPECT_THAT(errorOfFile(path), EndsWith("a': File too large"));
}

}  // namespace
}  // namespace drc::pbrt
