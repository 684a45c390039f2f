#include "scene/shapes/shape_disk.h"

#include "scene/shapes/shape_check.h"

namespace drc {
namespace {

TEST(Disk, HitsWhereItShould) {
    const ShapePtr disk = makeDisk({.height = 1, .radius = 2, .innerRadius = 0.5f, .phiMax = 270});
    const auto hit = disk->intersect(rayFrom(Vec3(0, 1, 4), Vec3(0, 0, -1)), 0);
    ASSERT_TRUE(hit);
    EXPECT_FLOAT_EQ(hit->t, 3);
    EXPECT_EQ(hit->ng, Vec3(0, 0, 1));
    EXPECT_NEAR(hit->uv.x, 90 / 270.0, 1e-6);
    EXPECT_NEAR(hit->uv.y, 1 - 0.5 / 1.5, 1e-6);
    EXPECT_NEAR(hit->dpdu.x, -1.5 * kPi, 1e-5);
    EXPECT_NEAR(hit->dpdv.y, -1.5, 1e-5);
    // Also from below.
    EXPECT_TRUE(disk->intersect(rayFrom(Vec3(0, 1, 0), Vec3(0, 0, 1)), 0));
    // Through the hole, outside, through the missing quarter, parallel, and behind the ray's origin.
    EXPECT_FALSE(disk->intersect(rayFrom(Vec3(0, 0.4f, 4), Vec3(0, 0, -1)), 0));
    EXPECT_FALSE(disk->intersect(rayFrom(Vec3(0, 2.1f, 4), Vec3(0, 0, -1)), 0));
    EXPECT_FALSE(disk->intersect(rayFrom(Vec3(1, -1, 4), Vec3(0, 0, -1)), 0));
    EXPECT_FALSE(disk->intersect(rayFrom(Vec3(-5, 1, 1), Vec3(1, 0, 0)), 0));
    EXPECT_FALSE(disk->intersect(rayFrom(Vec3(0, 1, 4), Vec3(0, 0, 1)), 0));
    EXPECT_FALSE(disk->intersect(rayFrom(Vec3(0, 1, 4), Vec3(0, 0, -1)), 3.5f));
    EXPECT_NEAR(disk->area(), 0.75 * kPi * (4 - 0.25), 1e-5);
    // The derivatives must be finite at the centre of a whole disk.
    EXPECT_TRUE(std::isfinite(makeDisk({})->intersect(rayFrom(Vec3(0, 0, 1), Vec3(0, 0, -1)), 0)->dpdv.x));
}

TEST(Disk, FacesUpUnlessReversed) {
    auto up = [](const Transform& t, bool reverse) {
        return makeDisk({.objectToWorld = t, .reverseOrientation = reverse})
                   ->intersect(rayFrom(Vec3(0.1f, 0.1f, 4), Vec3(0, 0, -1)), 0)
                   ->ng.z > 0;
    };
    EXPECT_TRUE(up(Transform(), false));
    EXPECT_FALSE(up(Transform(), true));
    EXPECT_TRUE(up(Transform::scale(-1, 1, 1), false));
    EXPECT_FALSE(up(Transform::scale(-1, 1, 1), true));
    EXPECT_FALSE(up(Transform::scale(1, 1, -1), false));
    EXPECT_FALSE(up(Transform::rotate(180, Vec3(1, 0, 0)), false));
}

TEST(Disk, TransformedSamplingAndDerivatives) {
    const Transform t =
        Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(50, Vec3(3, 1, 2)) * Transform::scale(1, 2, 0.5f);
    for (const DiskParams& p : {DiskParams{.objectToWorld = t}, DiskParams{.objectToWorld = t,
                                                                .reverseOrientation = true,
                                                                .height = 2,
                                                                .radius = 3,
                                                                .innerRadius = 1,
                                                                .phiMax = 250}}) {
        const ShapePtr disk = makeDisk(p);
        EXPECT_NEAR(disk->area(), 2 * (p.phiMax / 360) * kPi * (sqr(p.radius) - sqr(p.innerRadius)), 1e-4);
        checkSampling(*disk);
        const float r = 0.5f * (p.radius + p.innerRadius);
        const Vec3 target = t.point(Vec3(0.6f * r, 0.8f * r, p.height)), from = target + Vec3(1, 2, 3);
        checkDerivatives(*disk, rayFrom(from, normalize(target - from)), 1e-3f);
        checkSamplingFrom(*disk, target + Vec3(0.5f, 0.3f, 1));
    }
}

}  // namespace
}  // namespace drc
