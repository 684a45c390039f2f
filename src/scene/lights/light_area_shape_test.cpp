#include "math/frame.h"
#include "scene/lights/light.h"
#include "scene/shapes/curves.h"
#include "scene/shapes/shape_check.h"
#include "scene/shapes/shape_cone.h"
#include "scene/shapes/shape_cylinder.h"
#include "scene/shapes/shape_disk.h"
#include "scene/shapes/shape_hyperboloid.h"
#include "scene/shapes/shape_paraboloid.h"
#include "scene/shapes/shape_sphere.h"

namespace drc {
namespace {

// Irradiance at p on a surface with normal n, by light sampling. Occlusion of the emitter by itself is taken into
// account.
RunningMean irradiance(const Light& light, const Shape& shape, const Vec3& p, const Vec3& n, int samples) {
    Pcg32 rng(21);
    RunningMean r;
    for (int i = 0; i < samples; ++i) {
        const auto s = light.sample(p, rng.nextVec2());
        double value = 0;
        if (s) {
            const auto hit = shape.intersect(rayFrom(p, s->wi), 0);
            // Samples on curves are slightly nearer than the hit.
            if (hit && hit->t > 0.999f * s->distance && hit->t < 1.001f * s->distance + 0.05f)
                value = s->radiance.x * std::max(0.f, dot(n, s->wi)) / s->pdf;
        }
        r.add(value);
    }
    return r;
}

TEST(ShapeAreaLight, SphereAndDiskGiveTheIrradianceOfTheBooks) {
    // Sphere: pi L (r / d)^2. Disk, coaxial: pi L r^2 / (r^2 + d^2).
    const ShapePtr sphere = makeSphere({.radius = 1});
    const auto lamp = makeShapeAreaLight(sphere, Rgb(2.f), false);
    const RunningMean e = irradiance(*lamp, *sphere, Vec3(0, 0, 3), Vec3(0, 0, -1), 20000);
    EXPECT_NEAR(e.mean(), 2 * kPi / 9, 4 * std::sqrt(e.variance()) + 1e-3);
    const ShapePtr disk = makeDisk({.radius = 2});
    const auto panel = makeShapeAreaLight(disk, Rgb(2.f), false);
    const RunningMean f = irradiance(*panel, *disk, Vec3(0, 0, 1), Vec3(0, 0, -1), 20000);
    EXPECT_NEAR(f.mean(), 2 * kPi * 4 / 5, 4 * std::sqrt(f.variance()) + 1e-3);
    // Inside a sphere that emits inwards, the irradiance is pi L.
    const ShapePtr shell = makeSphere({.reverseOrientation = true});
    const auto glow = makeShapeAreaLight(shell, Rgb(1.f), false);
    const RunningMean g = irradiance(*glow, *shell, Vec3(0.3f, 0.2f, 0.4f), Vec3(0, 0, 1), 40000);
    EXPECT_NEAR(g.mean(), kPi, 4 * std::sqrt(g.variance()) + 1e-3);
}

TEST(ShapeAreaLight, EmitsFromTheSideOfTheNormal) {
    const ShapePtr disk = makeDisk({});
    const auto oneSided = makeShapeAreaLight(disk, Rgb(1.f), false), both = makeShapeAreaLight(disk, Rgb(1.f), true);
    EXPECT_TRUE(oneSided->sample(Vec3(0, 0, 1), Vec2(0.3f, 0.3f)));
    EXPECT_FALSE(oneSided->sample(Vec3(0, 0, -1), Vec2(0.3f, 0.3f)));
    EXPECT_TRUE(both->sample(Vec3(0, 0, -1), Vec2(0.3f, 0.3f)));
    EXPECT_FALSE(oneSided->sample(Vec3(0.5f, 0, 0), Vec2(0.3f, 0.3f)));  // edge-on
    EXPECT_NEAR(oneSided->power(1).x, kPi * kPi, 1e-5);
    EXPECT_NEAR(both->power(1).x, 2 * kPi * kPi, 1e-5);
    EXPECT_FALSE(oneSided->bounds().empty());
}

// The same irradiance, estimated with uniformly distributed directions.
RunningMean irradianceByDirections(const AreaLight& light, const Shape& shape, const Vec3& p, const Vec3& n,
                                   int samples) {
    Pcg32 rng(12);
    RunningMean r;
    const Frame frame = Frame::fromNormal(n);
    for (int i = 0; i < samples; ++i) {
        const Vec3 w = frame.toWorld(sampleCosineHemisphere(rng.nextVec2()));
        const auto hit = shape.intersect(rayFrom(p, w), 0);
        r.add(hit ? kPi * light.emitted({p + w * hit->t, hit->ng, hit->part, hit->uv}, -w).x : 0);
    }
    return r;
}

// Dark, with a bright patch.
Emission patch() {
    LightImage image{8, 8, {}};
    for (int i = 0; i < 64; ++i) image.texels.push_back(Rgb(i % 8 > 4 && i / 8 > 2 ? 3.f : 0.1f));
    return {std::make_shared<EmissionImage>(std::move(image)), Rgb(1.f)};
}

TEST(ShapeAreaLight, EveryShapeLightsAsItLooks) {
    const Transform t = Transform::rotate(70, Vec3(1, 2, 0)) * Transform::scale(1, 1.4f, 1);
    auto tube = std::make_shared<Curves>(CurveType::Cylinder, false);
    tube->add({Vec3(-1, 0, 0), Vec3(-0.5f, 0.5f, 0), Vec3(0.5f, -0.5f, 0), Vec3(1, 0, 0.4f)}, {0.3f, 0.2f});
    auto ribbon = std::make_shared<Curves>(CurveType::Ribbon, false);
    ribbon->add({Vec3(-1, 0, 0), Vec3(-0.5f, 0.5f, 0), Vec3(0.5f, -0.5f, 0), Vec3(1, 0, 0.4f)}, {0.5f, 0.4f},
                {Vec3(0, 0, 1), normalize(Vec3(0, 0.6f, 1))});
    const ShapePtr shapes[] = {makeCylinder({.objectToWorld = t, .radius = 0.6f, .phiMax = 220}),
                               makeCone({.objectToWorld = t}),
                               makeParaboloid({.objectToWorld = t, .radius = 0.8f}),
                               makeHyperboloid({.objectToWorld = t, .p1 = Vec3(0.8f, 0, -1), .p2 = Vec3(0, 0.8f, 1)}),
                               makeSphere({.objectToWorld = Transform::scale(0.6f, 0.6f, 0.6f)}),
                               makeDisk({.objectToWorld = t, .innerRadius = 0.3f}),
                               tube,
                               ribbon};
    const Vec3 p(0.3f, 0.4f, 2.5f), n = normalize(Vec3(0.1f, 0.2f, -1));
    int index = 0;
    for (const ShapePtr& shape : shapes)
        for (const int kind : {0, 1, 2, 3}) {
            const bool twoSided = kind % 2 == 1;
            const auto light = makeShapeAreaLight(shape, kind < 2 ? Emission(Rgb(1.f)) : patch(), twoSided);
            const RunningMean a = irradiance(*light, *shape, p, n, 2500);
            const RunningMean b = irradianceByDirections(*light, *shape, p, n, 5000);
            expectSame(a, b, 0.01 * b.mean(), std::to_string(index++).c_str());
            if (twoSided) {
                EXPECT_GT(b.mean(), 0.02);
            }
            EXPECT_GT(light->power(1).x, 0);
        }
}

TEST(ShapeAreaLight, AnImageIsSampledByWhatItEmits) {
    // A sphere with a small bright spot: at most twice the variance of the better of directions and image, and far less
    // than that of directions alone.
    LightImage image{64, 32, std::vector<Rgb>(64 * 32, Rgb(0.01f))};
    image.texels[16 * 64 + 1] = Rgb(500.f);
    const Emission spot(std::make_shared<EmissionImage>(std::move(image)), Rgb(1.f));
    const auto light = makeShapeAreaLight(makeSphere({}), spot, false),
               plain = makeShapeAreaLight(makeSphere({}), Rgb(1.f), false);
    const Vec3 p(6, 1, 0.5f);
    const auto variance = [&](const AreaLight& sampled) {
        Pcg32 rng(3);
        RunningMean mean;
        constexpr int kSamples = 40000;
        for (int i = 0; i < kSamples; ++i) {
            const auto s = sampled.sample(p, rng.nextVec2());
            mean.add(s ? double(spot.at(s->uv).x / s->pdf) : 0.0);
        }
        return mean.variance() * kSamples / (mean.mean() * mean.mean());
    };
    EXPECT_GT(variance(*plain), 50);
    EXPECT_LT(variance(*light), 3);
}

TEST(ShapeAreaLight, PowerIsThatOfTheImage) {
    // The upper half of a sphere is white: v is theta / pi.
    LightImage image{1, 64, {}};
    for (int y = 0; y < 64; ++y) image.texels.push_back(Rgb(y < 32 ? 2.f : 0.f));
    const Emission half(std::make_shared<EmissionImage>(std::move(image)), Rgb(1, 2, 3));
    const auto light = makeShapeAreaLight(makeSphere({.radius = 2}), half, true);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(light->power(1)[c] / (2 * kPi * 16 * kPi * float(c + 1)), 1, 0.01f);
}

TEST(ShapeAreaLight, PdfMatchesSample) {
    const ShapePtr shape = makeSphere({.objectToWorld = Transform::translate(Vec3(1, 2, 3)), .zMax = 0.5f});
    const auto light = makeShapeAreaLight(shape, Rgb(1.f), true);
    Pcg32 rng(4);
    const Vec3 p(4, 1, 5);
    for (int i = 0; i < 1000; ++i) {
        const auto s = light->sample(p, rng.nextVec2());
        if (!s) continue;
        const auto hit = shape->intersect(rayFrom(p, s->wi), 0);
        if (!hit || std::abs(hit->t - s->distance) > 1e-4f * s->distance || absDot(hit->ng, s->wi) < 0.05f) continue;
        EmitterHit e;
        e.p = p + s->wi * hit->t;
        e.ng = hit->ng;
        EXPECT_NEAR(light->pdf(p, s->wi, e), s->pdf, 1e-2f * s->pdf);
    }
}

}  // namespace
}  // namespace drc
