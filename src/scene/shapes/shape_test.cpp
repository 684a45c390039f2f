#include "scene/shapes/shape.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(Bounds, AreThoseOfBoth) {
    Bounds a, b;
    a.extend(Vec3(1, 2, 3));
    b.extend(Vec3(-1, 5, 3));
    a.extend(b);
    EXPECT_EQ(a.min, Vec3(-1, 2, 3));
    EXPECT_EQ(a.max, Vec3(1, 5, 3));
}

TEST(Bounds, AreNotExtendedByWhatIsEmpty) {
    Bounds a;
    a.extend(Bounds());
    EXPECT_TRUE(a.empty());
    a.extend(Vec3(1, 2, 3));
    a.extend(Bounds());
    EXPECT_EQ(a.min, Vec3(1, 2, 3));
    EXPECT_EQ(a.max, Vec3(1, 2, 3));
}

}  // namespace
}  // namespace drc
