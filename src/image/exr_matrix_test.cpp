#include "image/exr_matrix.h"

#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

class ExrMatrix : public FolderTest {
  protected:
    void writeWith(const ExrAttributes& attributes) const {
        const Image image(2, 2);
        ExrStorage storage;
        storage.attributes = attributes;
        writeExr(path("a.exr"), {{"", &image}}, {}, {}, storage);
    }
};

const Transform kTurnedAndMoved = Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(30, Vec3(0, 1, 0));

// OpenEXR's own library sees the matrix that its documentation describes: one for row vectors.
TEST_F(ExrMatrix, ActsOnRowVectorsInTheFile) {
    writeWith({{"worldToCamera", matrixAttribute(kTurnedAndMoved)},
               {"worldToNDC", matrixAttribute(Transform::perspective(60, 1, 10))}});
    const Imf::InputFile file(path("a.exr").c_str());
    ASSERT_TRUE(Imf::hasWorldToCamera(file.header()) && Imf::hasWorldToNDC(file.header()));
    const Imath::V3f point = Imath::V3f(4, 5, 6) * Imf::worldToCamera(file.header());
    const Vec3 expected = kTurnedAndMoved.point(Vec3(4, 5, 6));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(point[i], expected[i], 1e-5f);
    const Imath::V3f projected = Imath::V3f(1, 2, 4) * Imf::worldToNDC(file.header());
    EXPECT_NEAR(projected.x, 1 / 4.f / std::tan(kPi / 6), 1e-5f);
}

TEST_F(ExrMatrix, ComesBackFromAFile) {
    writeWith({{"m", matrixAttribute(kTurnedAndMoved)}});
    const ExrAttributes attributes = readImageFile(path("a.exr")).storage.attributes;
    const std::optional<Transform> matrix = matrixIn(attributes, "m");
    ASSERT_TRUE(matrix);
    for (int i = 0; i < 16; ++i) EXPECT_FLOAT_EQ(matrix->at(i / 4, i % 4), kTurnedAndMoved.at(i / 4, i % 4));
    EXPECT_FALSE(matrixIn(attributes, "n"));
    EXPECT_FALSE(matrixIn({{"m", {"float", "1234"}}}, "m"));
    ExrAttribute broken = matrixAttribute(kTurnedAndMoved);
    broken.value.replace(0, 4, "\xff\xff\xff\xff");
    EXPECT_FALSE(matrixIn({{"m", broken}}, "m"));
}

}  // namespace
}  // namespace drc
