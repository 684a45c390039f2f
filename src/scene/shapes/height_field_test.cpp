#include "scene/shapes/height_field.h"

#include <gmock/gmock.h>

namespace drc {
namespace {

TEST(HeightField, GridHeightsAndCoordinates) {
    const std::vector<float> heights = {0, 1, 2, 3, 4, 5};
    const TriangleMesh mesh = makeHeightField(3, 2, heights);
    ASSERT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.positions[1], Vec3(0.5f, 0, 1));
    EXPECT_EQ(mesh.positions[5], Vec3(1, 1, 5));
    EXPECT_EQ(mesh.uvs[4], Vec2(0.5f, 1));
    EXPECT_THAT(mesh.indices, testing::ElementsAre(0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4));
    double area = 0;
    for (uint32_t i = 0; i < mesh.triangleCount(); ++i) {
        EXPECT_GT(mesh.geometricNormal(i).z, 0);
        area += mesh.area(i) * mesh.geometricNormal(i).z;  // projected area
    }
    EXPECT_NEAR(area, 1, 1e-6);
}

}  // namespace
}  // namespace drc
