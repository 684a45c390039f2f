#include "pbrt/gzip.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include "pbrt/ply_reader.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string gzipped(const std::string& text) {
    z_stream z{};
    deflateInit2(&z, 9, Z_DEFLATED, 16 + MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
    std::string result(deflateBound(&z, text.size()) + 64, '\0');
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    z.avail_in = uInt(text.size());
    z.next_out = reinterpret_cast<Bytef*>(result.data());
    z.avail_out = uInt(result.size());
    deflate(&z, Z_FINISH);
    result.resize(z.total_out);
    deflateEnd(&z);
    return result;
}

std::string text() {
    std::string result;
    for (unsigned i = 0; i < 300000; ++i) result += std::to_string(i * 7919 % 10007) + " ";
    return result;
}

TEST(Gzip, RoundTrip) {
    const std::string plain = text(), packed = gzipped(plain);
    EXPECT_TRUE(isGzip(packed));
    EXPECT_FALSE(isGzip(plain));
    EXPECT_FALSE(isGzip("\x1f"));
    EXPECT_EQ(gunzip(packed, "a.gz"), plain);
    EXPECT_EQ(gunzip(gzipped(""), "a.gz"), "");
    EXPECT_EQ(gunzip(packed + gzipped("more"), "a.gz"), plain + "more");
}

TEST(Gzip, DamageIsAnErrorAtEveryLength) {
    const std::string packed = gzipped(text());
    for (size_t n = 2; n < packed.size(); n += 1 + packed.size() / 23)
        EXPECT_EQ(errorOf([&] { gunzip(packed.substr(0, n), "a.gz"); }), "a.gz: the gzip stream is cut short") << n;
    std::string flipped = packed;
    flipped[packed.size() / 2] = char(flipped[packed.size() / 2] ^ 0x55);
    EXPECT_THAT(errorOf([&] { gunzip(flipped, "a.gz"); }), StartsWith("a.gz: the gzip stream is damaged"));
    EXPECT_THAT(errorOf([&] { gunzip(packed + "rubbish", "a.gz"); }), StartsWith("a.gz: the gzip stream is damaged"));
}

TEST(Gzip, BombsAreRefused) {
    const std::string bomb = gzipped(std::string(size_t(4) << 20, '\0'));
    EXPECT_LT(bomb.size(), 8000u);
    EXPECT_THAT(errorOf([&] { gunzip(bomb, "a.gz", {size_t(1) << 20, 250}); }), HasSubstr("grows beyond 1 MiB"));
    EXPECT_EQ(gunzip(bomb, "a.gz", {size_t(4) << 20, 250}).size(), size_t(4) << 20);
    EXPECT_EQ(gunzip(bomb, "a.gz", {0, 1040}).size(), size_t(4) << 20);
}

TEST(Gzip, ManySmallStreamsAreOneText) {
    std::string many;
    for (int i = 0; i < 20000; ++i) many += gzipped("a");
    EXPECT_EQ(gunzip(many, "a.gz"), std::string(20000, 'a'));
}

TEST(Gzip, MeshesAndScenes) {
    const TemporaryFolder folder;
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n";
    folder.write("a.ply.gz", gzipped(ply));
    EXPECT_EQ(readPly(folder.path() + "/a.ply.gz").positions.at(1), Vec3(0, 1, 0));
    const std::string scene = folder.write(
        "s.pbrt.gz", gzipped("Film \"rgb\"\nWorldBegin\nShape \"plymesh\" \"string filename\" \"a.ply.gz\"\n"));
    EXPECT_EQ(loadPbrtFile(scene)->primitives.at(0).mesh->triangleCount(), 1u);
    folder.write("b.ply.gz", gzipped(ply).substr(0, 60));
    EXPECT_THAT(errorOfWorld("Shape \"plymesh\" \"string filename\" \"b.ply.gz\"", folder.path()),
                HasSubstr("b.ply.gz: the gzip stream is cut short"));
}

}  // namespace
}  // namespace drc::pbrt
