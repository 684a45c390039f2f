// Checks that every shape must pass.
#pragma once
#include <gtest/gtest.h>

#include "math/rng.h"
#include "math/warp.h"
#include "scene/ray_testing.h"
#include "scene/shapes/shape.h"

namespace drc {

// A running mean with its standard error.
class RunningMean {
  public:
    void add(double x) {
        ++n_;
        const double d = x - mean_;
        mean_ += d / n_;
        m2_ += d * (x - mean_);
    }
    double mean() const { return mean_; }
    double variance() const { return m2_ / (double(n_) * (n_ - 1)); }  // variance of the mean

  private:
    int n_ = 0;
    double mean_ = 0, m2_ = 0;
};

// Expects equality within four standard errors; slack allows for the rounding of estimates without variance.
inline void expectSame(const RunningMean& a, const RunningMean& b, double slack, const char* what) {
    EXPECT_NEAR(a.mean(), b.mean(), 4 * std::sqrt(a.variance() + b.variance()) + slack) << what;
}

// Whether (u, v) are the same; u may have gone once around.
inline bool isSamePlace(const Vec2& a, const Vec2& b) {
    const float du = std::abs(a.x - b.x);
    return std::min(du, 1 - du) < 2e-3f && std::abs(a.y - b.y) < 2e-3f;
}

// Checks that spotAt(uv) is where rays find uv, and that its area adds up to that of the shape.
inline void checkSpots(const Shape& shape) {
    constexpr int kSide = 200;
    double area = 0;
    int missed = 0;
    const float h = 1e-3f * shape.bounds().radius();
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const Vec2 uv((float(i) + 0.5f) / kSide, (float(j) + 0.5f) / kSide);
            const auto spot = shape.spotAt(uv);
            ASSERT_TRUE(spot);
            if (!(spot->area > 0)) continue;
            area += double(spot->area) / (kSide * kSide);
            EXPECT_NEAR(length(spot->ng), 1, 1e-5);
            const auto hit = shape.intersect(rayFrom(spot->p + spot->ng * h, -spot->ng), 0);
            if (!hit || !isSamePlace(uv, hit->uv) || dot(hit->ng, spot->ng) < 0.999f) ++missed;
        }
    EXPECT_LE(missed, kSide * kSide / 1000);  // at an apex, and where normals turn within h
    EXPECT_NEAR(area, shape.area(), 2e-3 * shape.area());
}

// Compares sampleFrom(p) with uniformly sampled directions, by the solid angle that the shape subtends at p and its
// first moments. Also checks that pdfFrom(), points and normals agree with intersect().
inline void checkSamplingFrom(const Shape& shape, const Vec3& p, int samples = 40000) {
    Pcg32 rng(17);
    RunningMean bySample[4], byDirection[4];
    int visible = 0, different = 0;
    for (int i = 0; i < samples; ++i) {
        const ShapeSample s = shape.sampleFrom(p, rng.nextVec2());
        const Vec3 d = s.p - p;
        const float distance = length(d);
        const Vec3 w = d / distance;
        const auto hit = shape.intersect(rayFrom(p, w), 0);
        double value = 0;
        // Samples may be hidden behind another part of the shape, or lie exactly on its edge.
        if (hit && std::abs(hit->t - distance) < 1e-3f * distance && s.pdf > 0) {
            value = 1 / s.pdf;
            ++visible;
            const float pdf = shape.pdfFrom(p, w, {s.p, s.ng});
            EXPECT_NEAR(pdf, s.pdf, 2e-3f * s.pdf);
            if (absDot(hit->ng, w) > 0.05f) {
                different += !isSamePlace(s.uv, hit->uv);
                different += std::abs(dot(hit->ng, s.ng) - 1) > 1e-3f;
                EXPECT_NEAR(shape.pdfFrom(p, w, {p + w * hit->t, hit->ng}), s.pdf, 2e-2f * s.pdf);
            }
        }
        for (int k = 0; k < 4; ++k) bySample[k].add(value * (k < 3 ? double(w[k]) : 1.0));
        const Vec3 u = sampleUniformSphere(rng.nextVec2());
        const double seen = shape.intersect(rayFrom(p, u), 0) ? 4 * kPi : 0;
        for (int k = 0; k < 4; ++k) byDirection[k].add(seen * (k < 3 ? double(u[k]) : 1.0));
    }
    EXPECT_GT(visible, samples / 10);
    EXPECT_LE(different, samples / 5000);  // some at the apex of a cone
    const char* names[] = {"x", "y", "z", "solid angle"};
    for (int k = 0; k < 4; ++k) expectSame(bySample[k], byDirection[k], 1e-3, names[k]);
}

// Checks that points of sample() are on the surface (a ray along the normal hits them) and inside the bounds, that the
// expectation of 1 / pdf is the area, and spotAt().
inline void checkSampling(const Shape& shape, int samples = 4000) {
    Pcg32 rng(5);
    RunningMean area;
    const Bounds b = shape.bounds();
    for (int i = 0; i < samples; ++i) {
        const ShapeSample s = shape.sample(rng.nextVec2());
        area.add(1 / s.pdf);
        EXPECT_NEAR(length(s.ng), 1, 1e-5);
        for (int k = 0; k < 3; ++k) {
            EXPECT_GE(s.p[k], b.min[k]);
            EXPECT_LE(s.p[k], b.max[k]);
        }
        // Starts slightly above the surface and looks down along the normal.
        const float h = 1e-3f * b.radius();
        const auto hit = shape.intersect(rayFrom(s.p + s.ng * h, -s.ng), 0);
        if (!hit) continue;  // exactly on an edge
        EXPECT_NEAR(hit->t, h, 2e-2f * h);
        EXPECT_NEAR(dot(hit->ng, s.ng), 1, 1e-3);
        EXPECT_TRUE(isSamePlace(s.uv, hit->uv)) << s.uv << hit->uv;
        EXPECT_NEAR(shape.pdf({s.p, s.ng, s.uv, s.part}), s.pdf, 1e-3f * s.pdf);
    }
    EXPECT_NEAR(area.mean(), shape.area(), 4 * std::sqrt(area.variance()) + 1e-4 * shape.area());
    checkSpots(shape);
}

// Compares dpdu and dpdv with finite differences: a small step in the tangent plane must change uv accordingly.
inline void checkDerivatives(const Shape& shape, const Ray& ray, float step) {
    const auto a = shape.intersect(ray, 0);
    ASSERT_TRUE(a);
    const Vec3 pa = ray.o + ray.d * a->t;
    EXPECT_NEAR(std::abs(dot(normalize(cross(a->dpdu, a->dpdv)), a->ng)), 1, 1e-4);
    for (const Vec3& direction : {normalize(a->dpdu), normalize(a->dpdv)}) {
        const Vec3 o = pa + direction * step + a->ng * (10 * step);
        const auto b = shape.intersect(rayFrom(o, -a->ng), 0);
        ASSERT_TRUE(b);
        const Vec2 duv = b->uv - a->uv;
        const Vec3 moved = a->dpdu * duv.x + a->dpdv * duv.y;
        EXPECT_NEAR(length(moved - direction * step), 0, 0.05f * step);
    }
}

}  // namespace drc
