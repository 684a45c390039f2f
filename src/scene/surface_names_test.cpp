#include "scene/surface_names.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(SurfaceNames, KeepsEveryStringOnce) {
    SurfaceNames names;
    std::vector<uint32_t> rows;
    for (int i = 0; i < 1000; ++i) {
        // The table must not point to strings of its caller.
        const std::string material = "wood", mesh = "board" + std::to_string(i) + ".ply";
        rows.push_back(names.add({material, "plastic", "plymesh", mesh, "house.pbrt", i + 1}));
    }
    EXPECT_EQ(names.size(), 1000u);
    const SurfaceName first = names.at(rows[0]), last = names.at(rows[999]);
    EXPECT_EQ(last.material, "wood");
    EXPECT_EQ(last.materialKind, "plastic");
    EXPECT_EQ(last.shapeKind, "plymesh");
    EXPECT_EQ(last.meshFile, "board999.ply");
    EXPECT_EQ(last.file, "house.pbrt");
    EXPECT_EQ(last.line, 1000);
    EXPECT_EQ(first.meshFile, "board0.ply");
    // Not only equal: the same bytes.
    EXPECT_EQ(first.material.data(), last.material.data());
    EXPECT_EQ(first.file.data(), last.file.data());
    const SurfaceNames moved = std::move(names);
    EXPECT_EQ(moved.at(rows[0]).meshFile, "board0.ply");
}

TEST(SurfaceNames, SaysNothingOfSurfacesWithoutARow) {
    SurfaceNames names;
    names.add({"a", "b", "c", "d", "e", 1});
    const SurfaceName none = names.at(SurfaceNames::kNone);
    EXPECT_TRUE(none.material.empty() && none.materialKind.empty() && none.shapeKind.empty() && none.file.empty());
    EXPECT_EQ(none.line, 0);
}

}  // namespace
}  // namespace drc
