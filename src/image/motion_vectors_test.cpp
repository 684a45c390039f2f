#include "image/motion_vectors.h"

#include <gtest/gtest.h>

#include "image/image_layers.h"

namespace drc {
namespace {

constexpr FilmSize kFilm{200, 100};

// A camera at `eye` that looks along z; the film is 4 x 2 at the distance 1. y is up.
FrameGeometry frameFrom(const Vec3& eye) {
    const Transform toCamera = Transform::translate(-eye);
    const Transform toNdc({.25, 0, .5, 0, 0, -.5, .5, 0, 0, 0, 0, 1, 0, 0, 1, 0});
    return {toCamera, toNdc * toCamera, {}};
}

Image pixelWith(const std::vector<float>& values, std::vector<std::string> names) {
    Image image(1, 1, std::move(names));
    image.data() = values;
    return image;
}

std::vector<float> vectorsAt(const Vec3& p, const FrameGeometry& now, const FrameGeometry* previous,
                             const FrameGeometry* next, float depth = 1, float object = 1) {
    return motionVectors(pixelWith({p.x, p.y, p.z}, {"X", "Y", "Z"}), pixelWith({depth}, {"Z"}),
                         pixelWith({object}, {"X"}), now, previous, next, kFilm)
        .data();
}

TEST(MotionVectors, ProjectToPixels) {
    const auto at = pixelOf(Vec3(2, 1, 2), frameFrom(Vec3(0.f)), kFilm);
    ASSERT_TRUE(at);
    EXPECT_FLOAT_EQ(at->x, 150);  // half of the right half
    EXPECT_FLOAT_EQ(at->y, 25);   // half of the upper half
    EXPECT_FALSE(pixelOf(Vec3(2, 1, -2), frameFrom(Vec3(0.f)), kFilm));
}

// A camera that goes to the right and up takes what it shows to the left and down: it was farther right and up.
TEST(MotionVectors, HaveTheSignsOfCycles) {
    const FrameGeometry previous = frameFrom(Vec3(-0.1f, -0.2f, 0)), now = frameFrom(Vec3(0.f)),
                        next = frameFrom(Vec3(0.3f, 0.4f, 0));
    const auto v = vectorsAt(Vec3(0, 0, 2), now, &previous, &next);
    EXPECT_NEAR(v[0], 2.5f, 1e-4f);  // previous minus now
    EXPECT_NEAR(v[1], 5, 1e-4f);
    EXPECT_NEAR(v[2], 7.5f, 1e-4f);  // now minus next
    EXPECT_NEAR(v[3], 10, 1e-4f);
}

TEST(MotionVectors, FollowObjects) {
    FrameGeometry previous = frameFrom(Vec3(0.f)), now = previous;
    previous.objects.add(5, Transform::translate(Vec3(1, 0, 0)) * Transform::rotate(90, Vec3(0, 1, 0)));
    now.objects.add(5, Transform::rotate(90, Vec3(0, 1, 0)));
    const auto v = vectorsAt(Vec3(0, 0, 2), now, &previous, nullptr, 2, 5);
    EXPECT_NEAR(v[0], 25, 1e-3f);
    EXPECT_EQ(v[2], 0);
    EXPECT_EQ(vectorsAt(Vec3(0, 0, 2), now, &previous, nullptr, 2, 4)[0], 0);  // another object stands still
}

TEST(MotionVectors, AreZeroWhereThereIsNothing) {
    const FrameGeometry previous = frameFrom(Vec3(-0.1f, 0, 0)), behind = frameFrom(Vec3(0, 0, 9)),
                        now = frameFrom(Vec3(0.f));
    EXPECT_EQ(vectorsAt(Vec3(0, 0, 2), now, &previous, nullptr, kNoDepth), std::vector<float>(4));
    EXPECT_EQ(vectorsAt(Vec3(0, 0, 2), now, &behind, nullptr), std::vector<float>(4));
}

}  // namespace
}  // namespace drc
