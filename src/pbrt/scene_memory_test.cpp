// Scenes in which a few bytes expand to more than the available memory. Each must give an error at its place.
// scene_limits_test.cpp has scenes that no machine could render.
#include <gmock/gmock.h>

#include "base/memory_testing.h"
#include "pbrt/test_scenes.h"
#include "scene/scene.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr uint64_t kMiB = 1 << 20;

// So thin that each segment is split into the maximum of 64 pieces.
const std::string kBent = "Shape \"curve\" \"float width\" 1e-6 \"point P\" [0 0 0  1 5 0  2 -5 1  3 0 0]\n";

std::string errorWithPieces(const std::string& world, size_t pieces) {
    return errorOf(
        [&] { loadPbrtString("WorldBegin\n" + world + "WorldEnd\n", ".", {.curvePieces = pieces}, "s.pbrt"); });
}

TEST(SceneMemory, PiecesOfCurvesAreCounted) {
    EXPECT_EQ(errorWithPieces(kBent + kBent, 128), "");
    EXPECT_THAT(errorWithPieces(kBent + kBent, 127),
                StartsWith("s.pbrt:3:7: this curve is so thin and bent that it is cut into 64 pieces, "
                           "and 63 may be added to the scene's"));
    // Whether they are stored together, as curves of the same type are, or separately.
    EXPECT_THAT(errorWithPieces(kBent + "Material \"mirror\"\n" + kBent + kBent, 130), StartsWith("s.pbrt:5:7: "));
    EXPECT_EQ(errorWithPieces("Shape \"curve\" \"point P\" [0 0 0  1 0 0  2 0 0  3 0 0]\n", 1), "");
}

TEST(SceneMemory, CurvesOfManyPieces) {
    std::string points;
    for (int i = 0; i < 1000; ++i) points += "0 0 0 9 9 0 ";
    const AddressSpaceLimit limit(16 * kMiB);
    EXPECT_THAT(
        errorOfWorld("Shape \"curve\" \"string basis\" \"bspline\" \"float width\" 1e-6 \"point P\" [" + points + "]"),
        AllOf(StartsWith("s.pbrt:2:7: curves of 127808 pieces needs about 21 MiB of memory"),
              HasSubstr(" are available")));
}

// Each curve is small, and they are stored together.
TEST(SceneMemory, ManyCurvesOfSomePieces) {
    std::string segments, shapes;
    for (int i = 0; i < 5; ++i) segments += "0 5 0  1 -5 1  2 0 0  ";
    const std::string shape = "Shape \"curve\" \"float width\" 1e-6 \"point P\" [0 0 0 " + segments + "]\n";
    for (int i = 0; i < 2000; ++i) shapes += shape;
    const AddressSpaceLimit limit(48 * kMiB);
    EXPECT_THAT(errorOfWorld(shapes), AllOf(StartsWith("s.pbrt:"), HasSubstr(":7: curves of "),
                                            HasSubstr(" of memory, and "), HasSubstr("Shape \"curve\"")));
}

std::string subdividedSphere(int levels) {
    return "Shape \"loopsubdiv\" \"integer nlevels\" " + std::to_string(levels) +
           " \"integer indices\" [0 1 4 1 2 4 2 3 4 3 0 4 1 0 5 2 1 5 3 2 5 0 3 5]"
           " \"point P\" [1 0 0 0 1 0 -1 0 0 0 -1 0 0 0 1 0 0 -1]\n";
}

// Subdividing alone would fit into memory, but not the acceleration structure of the triangles.
TEST(SceneMemory, SubdivisionSurfaces) {
    const AddressSpaceLimit limit(256 * kMiB);
    EXPECT_THAT(errorOfWorld(subdividedSphere(9)),
                StartsWith("s.pbrt:2:7: cannot load the mesh: subdividing to 2.1e+06 triangles needs about 320 MiB"));
}

TEST(SceneMemory, LightsOfManyTriangles) {
    const AddressSpaceLimit limit(48 * kMiB);
    EXPECT_EQ(errorOfWorld(subdividedSphere(7)), "");
    EXPECT_THAT(errorOfWorld("AreaLightSource \"diffuse\"\n" + subdividedSphere(7)),
                StartsWith("s.pbrt:3:7: a light of 131072 triangles needs about 56 MiB of memory"));
}

}  // namespace
}  // namespace drc::pbrt
