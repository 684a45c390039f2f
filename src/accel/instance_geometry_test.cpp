#include "accel/instance_geometry.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

const Vec3 kAxis(1, 2, -1);

// Largest difference between Embree's interpolation and ours, measured on the images of the unit vectors and the
// origin.
float strayOf(const AnimatedTransform& motion) {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene object = rtcNewScene(device);
    rtcCommitScene(object);
    RTCGeometry instance = makeInstanceGeometry(device, object, motion);
    rtcCommitGeometry(instance);
    float worst = 0;
    for (int i = 0; i <= 100; ++i) {
        const float time = float(i) / 100;
        const Transform a = instanceToWorld(instance, time), b = motion.at(time);
        for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
            worst = std::max(worst, length(a.point(p) - b.point(p)));
    }
    rtcReleaseGeometry(instance);
    rtcReleaseScene(object);
    rtcReleaseDevice(device);
    return worst;
}

TEST(InstanceGeometry, FollowsTheMotion) {
    const Transform placed = Transform::translate(Vec3(3, 1, 2)) * Transform::rotate(40, Vec3(0, 1, 1));
    EXPECT_LT(strayOf(placed), 1e-5f);
    EXPECT_LT(strayOf({placed, Transform::translate(Vec3(0, 4, 0)) * placed}), 1e-5f);
    // Rotating, growing, and both with a mirror. Embree's sines are accurate to a few units in the fourth decimal
    // place.
    const Transform turned = placed * Transform::rotate(150, kAxis);
    EXPECT_LT(strayOf({placed, turned}), 1e-3f);
    EXPECT_LT(strayOf({placed * Transform::scale(1, 2, 3), turned * Transform::scale(3, 1, 1)}), 3e-3f);
    EXPECT_LT(strayOf({placed * Transform::scale(-1, 1, 2), turned * Transform::scale(-2, 1, 1)}), 2e-3f);
}

TEST(InstanceGeometry, FollowsMotionsThatEmbreeDoesNotKnow) {
    // Stretch along other axes than the coordinate axes, and a motion within a motion.
    EXPECT_LT(strayOf({Transform::scale(1, 3, 1), Transform::scale(1, 3, 1) * Transform::rotate(120, kAxis)}), 4e-3f);
    const AnimatedTransform wheel(Transform(), Transform::rotate(170, Vec3(1, 0, 0)));
    const AnimatedTransform car(Transform::translate(Vec3(2, 0, 0)),
                                Transform::rotate(90, Vec3(0, 0, 1)) * Transform::translate(Vec3(2, 0, 0)));
    EXPECT_LT(strayOf(car * AnimatedTransform(Transform::translate(Vec3(0, 1, 0))) * wheel), 4e-3f);
}

}  // namespace
}  // namespace drc
