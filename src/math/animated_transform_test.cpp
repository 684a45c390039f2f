#include "math/animated_transform.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

void expectSame(const Transform& a, const Transform& b, float tolerance = 1e-5f) {
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            EXPECT_NEAR(a.at(row, column), b.at(row, column), tolerance) << row << " " << column;
}

const Vec3 kAxis(1, 2, -1);

TEST(AnimatedTransform, StandsStillWithoutDifference) {
    const Transform t = Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(20, kAxis);
    EXPECT_FALSE(AnimatedTransform().isAnimated());
    for (const AnimatedTransform& a :
         {AnimatedTransform(t), AnimatedTransform(t, t), AnimatedTransform(t) * Transform()}) {
        EXPECT_FALSE(a.isAnimated());
        EXPECT_EQ(a.steps(), 1u);
        EXPECT_TRUE(a.at(0.3f) == t);
        EXPECT_TRUE(a.end() == t);
    }
}

TEST(AnimatedTransform, EndsAreExactAndHold) {
    const Transform a = Transform::scale(2, 3, 4) * Transform::rotate(10, kAxis),
                    b = Transform::translate(Vec3(5, 0, 0));
    const AnimatedTransform t(a, b);
    EXPECT_TRUE(t.isAnimated());
    for (const float before : {-1.f, 0.f}) EXPECT_TRUE(t.at(before) == a);
    for (const float after : {1.f, 7.f}) EXPECT_TRUE(t.at(after) == b);
    // The motion starts without a jump.
    expectSame(t.at(1e-6f), a, 1e-4f);
    expectSame(t.at(1 - 1e-6f), b, 1e-4f);
}

TEST(AnimatedTransform, TurnsMovesAndGrowsEachByItself) {
    const auto at = [](float t) {
        return Transform::translate(Vec3(1, 0, 0) + Vec3(4, 2, -6) * t) * Transform::rotate(30 + 120 * t, kAxis) *
               Transform::scale(1 + t, 2 - t, 3);
    };
    const AnimatedTransform t(at(0), at(1));
    for (const float time : {0.1f, 0.25f, 0.5f, 0.9f}) expectSame(t.at(time), at(time));
    EXPECT_EQ(t.steps(), 2u);
}

TEST(AnimatedTransform, TurnsTheShorterWay) {
    const AnimatedTransform t(Transform::rotate(10, kAxis), Transform::rotate(300, kAxis));
    expectSame(t.at(0.5f), Transform::rotate(-25, kAxis));
}

TEST(AnimatedTransform, MirrorsAllTheTime) {
    const auto at = [](float t) { return Transform::rotate(100 * t, kAxis) * Transform::scale(-1, 2, 1 + t); };
    const AnimatedTransform t(at(0), at(1));
    for (const float time : {0.2f, 0.5f, 0.7f}) {
        EXPECT_TRUE(t.at(time).swapsHandedness());
        expectSame(t.at(time), at(time));
    }
}

TEST(AnimatedTransform, StretchesAlongAnyDirection) {
    const Transform turn = Transform::rotate(35, kAxis);
    const Transform stretch = turn * Transform::scale(3, 1, 1) * turn.inverse();
    const AnimatedTransform t(Transform(), stretch);
    expectSame(t.at(0.5f), turn * Transform::scale(2, 1, 1) * turn.inverse());
    EXPECT_EQ(t.steps(), AnimatedTransform::kMostSteps);
    // With a rotation added, neither part changes the other.
    const AnimatedTransform both(Transform(), Transform::rotate(90, kAxis) * stretch);
    expectSame(both.at(0.5f), Transform::rotate(45, kAxis) * turn * Transform::scale(2, 1, 1) * turn.inverse());
}

TEST(AnimatedTransform, ProductsAreThoseOfTheMoment) {
    const AnimatedTransform a(Transform::rotate(0, kAxis), Transform::rotate(170, kAxis));
    const AnimatedTransform b(Transform::translate(Vec3(1, 0, 0)), Transform::translate(Vec3(0, 3, 0)));
    const Transform c = Transform::scale(1, 2, 3);
    const AnimatedTransform product = AnimatedTransform(c) * a * b;
    EXPECT_TRUE(product.isAnimated());
    EXPECT_EQ(product.steps(), AnimatedTransform::kMostSteps);
    for (const float time : {0.f, 0.3f, 0.6f, 1.f}) expectSame(product.at(time), c * a.at(time) * b.at(time));
}

TEST(AnimatedTransform, InverseIsOfTheEnds) {
    const Transform a = Transform::translate(Vec3(1, 2, 3)), b = Transform::rotate(90, kAxis) * a;
    const AnimatedTransform t = AnimatedTransform(a, b).inverse();
    expectSame(t.start(), a.inverse());
    expectSame(t.end(), b.inverse());
    // The result is not the inverse of at(0.5): the inverses of both ends have the same translation, which must be kept
    // between.
    EXPECT_LT(length(t.at(0.5f).point(Vec3(0, 0, 0)) - Vec3(-1, -2, -3)), 1e-5f);
}

}  // namespace
}  // namespace drc
