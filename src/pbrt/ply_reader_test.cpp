#include "pbrt/ply_reader.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>

#include "base/log.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class PlyReader : public testing::Test {
  protected:
    TriangleMesh read(const std::string& contents) { return readPly(folder_.write("m.ply", contents)); }
    std::string errorOfReading(const std::string& contents) {
        return errorOf([&] { read(contents); });
    }
    TemporaryFolder folder_;
};

std::string header(const std::string& format, const std::string& vertexCount = "4",
                   const std::string& faceCount = "2") {
    return "ply\r\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + vertexCount +
           "\nproperty float x\nproperty float y\nproperty uchar quality\nproperty float z\nproperty double "
           "s\nproperty "
           "double t\nelement face " +
           faceCount + "\nproperty list uchar int vertex_indices\nproperty short tag\nend_header\n";
}

const float kPositions[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5f}, {0, 1, -2.25f}};

template <typename T>
void append(std::string& to, T value, bool swap) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (swap) std::reverse(bytes, bytes + sizeof(T));
    to.append(bytes, sizeof(T));
}

std::string binaryBody(bool swap) {
    std::string body;
    for (const auto& p : kPositions) {
        append(body, p[0], swap);
        append(body, p[1], swap);
        append(body, uint8_t(9), swap);
        append(body, p[2], swap);
        append(body, double(p[0]) / 2, swap);
        append(body, double(p[1]) / 4, swap);
    }
    append(body, uint8_t(4), swap);
    for (const int32_t i : {0, 1, 2, 3}) append(body, i, swap);
    append(body, int16_t(-1), swap);
    append(body, uint8_t(3), swap);
    for (const int32_t i : {3, 1, 0}) append(body, i, swap);
    append(body, int16_t(7), swap);
    return body;
}

void expectMesh(const TriangleMesh& mesh) {
    ASSERT_EQ(mesh.positions.size(), 4u);
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(mesh.positions[i], Vec3(kPositions[i][0], kPositions[i][1], kPositions[i][2]));
        EXPECT_EQ(mesh.uvs[i], Vec2(kPositions[i][0] / 2, kPositions[i][1] / 4));
    }
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 3, 0, 2, 3, 1, 0));
}

TEST_F(PlyReader, Ascii) {
    expectMesh(read(header("ascii") + "0 0 9 0 0 0\n1 0 9 0 0.5 0\n1 1 9 0.5 .5 .25\n0 1 9 -2.25e0 0 +0.25\n"
                                      "4 0 1 2 3 -1\n3 3 1 0 7"));
}

TEST_F(PlyReader, BinaryOfBothByteOrders) {
    expectMesh(read(header("binary_little_endian") + binaryBody(false)));
    expectMesh(read(header("binary_big_endian") + binaryBody(true)));
}

// As from old Macintosh programs, whose header may be followed by data that begin like a line end; and with a byte
// order mark, as from editors on Windows.
TEST_F(PlyReader, LineEndsAndMarks) {
    const auto with = [](std::string text, const std::string& lineEnd) {
        std::erase(text, '\r');
        for (size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + lineEnd.size()))
            text.replace(i, 1, lineEnd);
        return text;
    };
    const std::string ascii =
        "0 0 9 0 0 0\n1 0 9 0 0.5 0\n1 1 9 0.5 .5 .25\n0 1 9 -2.25e0 0 +0.25\n4 0 1 2 3 -1\n3 3 1 0 7";
    for (const char* lineEnd : {"\n", "\r\n", "\r"}) {
        expectMesh(read(with(header("ascii") + ascii, lineEnd)));
        expectMesh(read(with("\xEF\xBB\xBF" + header("ascii") + ascii, lineEnd)));
        expectMesh(read(with(header("binary_little_endian"), lineEnd) + binaryBody(false)));
    }
    const std::string vertices =
        "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty char z\n"
        "element face 1\nproperty list char char vertex_indices\nend_header\n";
    const std::string data("\n\r\0\0\0\0\0\1\0\3\0\1\2", 13);
    for (const char* lineEnd : {"\n", "\r\n", "\r"})
        EXPECT_EQ(read(with(vertices, lineEnd) + data).positions.at(0), Vec3(10, 13, 0));
}

TEST_F(PlyReader, NormalsAndOtherElements) {
    const TriangleMesh mesh = read(
        "ply\nformat ascii 1.0\nelement camera 1\nproperty list uchar float k\nelement vertex 3\nproperty float nx\n"
        "property float ny\nproperty float nz\nproperty float x\nproperty float y\nproperty float z\n"
        "property float u\nproperty float v\nelement face 1\nproperty list uint8 uint32 vertex_index\nend_header\n"
        "2 5 6\n0 0 1 1 2 3 4 5\n0 1 0 6 7 8 9 10\n1 0 0 0 0 0 0 0\n3 0 1 2\n");
    EXPECT_THAT(mesh.normals, ElementsAre(Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(1, 0, 0)));
    EXPECT_EQ(mesh.positions[1], Vec3(6, 7, 8));
    EXPECT_EQ(mesh.uvs[1], Vec2(9, 10));
}

TEST_F(PlyReader, TextureCoordinatesUnderAllNames) {
    const auto readWith = [&](const std::string& properties) {
        return read(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
            "z\n" +
            properties +
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0 1 2 3 4\n1 0 0 5 6 7 8\n0 1 0 9 10 11 12\n3 0 1 2\n");
    };
    const auto four = [](const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
        std::string result;
        for (const std::string& name : {a, b, c, d}) result += "property float " + name + "\n";
        return result;
    };
    EXPECT_EQ(readWith(four("s", "t", "a", "b")).uvs.at(0), Vec2(1, 2));
    EXPECT_EQ(readWith(four("a", "texture_u", "b", "texture_v")).uvs.at(0), Vec2(2, 4));
    EXPECT_EQ(readWith(four("texture_t", "texture_s", "a", "b")).uvs.at(1), Vec2(6, 5));
    // Of several pairs, pbrt's preferred one is taken, wherever it is in the file. An incomplete pair is ignored.
    EXPECT_EQ(readWith(four("s", "t", "u", "v")).uvs.at(0), Vec2(3, 4));
    EXPECT_EQ(readWith(four("u", "s", "a", "t")).uvs.at(0), Vec2(2, 4));
    EXPECT_TRUE(readWith(four("u", "t", "a", "b")).uvs.empty());
}

TEST_F(PlyReader, FacesOfAnyNumberOfCorners) {
    forgetWarnings();
    const TriangleMesh mesh = read(
        "ply\nformat ascii 1.0\nelement face 4\nproperty list uchar int face_indices\n"
        "property list uchar uint vertex_indices\nelement vertex 5\nproperty list uchar float weights\n"
        "property float z\nproperty float y\nproperty double x\nend_header\n"
        "1 7 5 0 1 2 3 4\n0 4 4 3 2 1\n2 1 1 2 0 1\n1 0 3 0 1 2\n"
        "0 1 2 3\n2 9 9 4 5 6\n0 0 0 0\n1 9 0 0 1\n0 0 1 0\n");
    EXPECT_EQ(mesh.positions[0], Vec3(3, 2, 1));
    EXPECT_EQ(mesh.positions[1], Vec3(6, 5, 4));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 3, 0, 2, 4, 0, 3, 4, 3, 2, 1, 4, 2, 0, 1, 2));
    EXPECT_EQ(warningCount(), 1);  // for the face of two corners, which is dropped
}

TEST_F(PlyReader, CutShortAnywhereIsAnError) {
    const std::string whole = header("binary_little_endian") + binaryBody(false);
    for (size_t size = 0; size < whole.size(); ++size) EXPECT_NE(errorOfReading(whole.substr(0, size)), "") << size;
}

TEST_F(PlyReader, HostileCountsAreRefusedBeforeAllocation) {
    for (const char* format : {"ascii", "binary_little_endian"}) {
        EXPECT_THAT(errorOfReading(header(format, "4000000000000")),
                    HasSubstr("is cut short: it promises 4000000000000"));
        EXPECT_THAT(errorOfReading(header(format, "18446744073709551615")), HasSubstr("is cut short"));
        EXPECT_THAT(errorOfReading(header(format, "99999999999999999999999")), HasSubstr("malformed count"));
        EXPECT_THAT(errorOfReading(header(format, "-1")), HasSubstr("malformed count"));
    }
    std::string body = binaryBody(false);
    const std::string endless =
        "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float "
        "y\nproperty float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n";
    EXPECT_THAT(errorOfReading(endless + "\xFF\xFF\xFF\x7F"), HasSubstr("a list of it has no end"));
}

TEST_F(PlyReader, SaysWhatIsWrong) {
    EXPECT_EQ(errorOf([] { readPly("/absent.ply"); }), "cannot read PLY file '/absent.ply': No such file or directory");
    EXPECT_THAT(errorOfReading("solid cube\n"), HasSubstr("m.ply:1:1: the PLY file is not a PLY file"));
    EXPECT_THAT(errorOfReading("ply\nformat ascii 1.0\nelement vertex 1\nproperty flaot x\nend_header\n"),
                HasSubstr("m.ply:4:1: the PLY file has a property of the unknown type 'flaot'"));
    EXPECT_THAT(
        errorOfReading(header("ascii") + "0 0 9 0 0 0\n1 0 9 zero 0.5 0\n1 1 9 0.5 .5 .25\n0 1 9 -2.25e0 0 0.25\n"
                                         "4 0 1 2 3 -1\n3 3 1 0 7\n"),
        HasSubstr("m.ply: the PLY file has 'zero' where a number should be"));
    EXPECT_THAT(errorOfReading(header("ascii") + "0 0 9 0 0 0\n1 0 9 0 0.5 0\n1 1 9 0.5 .5 .25\n0 1 9 -2.25e0 0 0.25\n"
                                                 "4 0 1 2 4 -1\n3 3 1 0 7\n"),
                HasSubstr("has a face with vertex 4, but only 4 vertices"));
}

}  // namespace
}  // namespace drc::pbrt
