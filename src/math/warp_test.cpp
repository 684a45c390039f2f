#include "math/warp.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "math/rng.h"

namespace drc {
namespace {

constexpr int kGrid = 256;

// Mean of f over a regular grid on the unit square.
double squareMean(const std::function<double(const Vec2&)>& f) {
    double sum = 0;
    for (int y = 0; y < kGrid; ++y)
        for (int x = 0; x < kGrid; ++x) sum += f(Vec2((x + 0.5f) / kGrid, (y + 0.5f) / kGrid));
    return sum / (kGrid * kGrid);
}

TEST(Warp, AtanInOctants) {
    for (float x = -1; x <= 1; x += 1e-4f) EXPECT_NEAR(atanInOctants(x), 4 / kPi * std::atan(x), 5e-7f);
}

TEST(Warp, SinCosInOctants) {
    for (int i = -10000; i <= 10000; ++i) {
        const float x = float(i) * 1e-4f;
        EXPECT_NEAR(sinCosInOctants(x).sin, std::sin(std::numbers::pi / 4 * x), 1.2e-7);
        EXPECT_NEAR(sinCosInOctants(x).cos, std::cos(std::numbers::pi / 4 * x), 1.2e-7);
    }
    EXPECT_EQ(sinCosInOctants(0).cos, 1);
}

TEST(Warp, SinCosOfTurn) {
    for (int i = 0; i <= 10000; ++i) {
        const float x = float(i) * 1e-4f;
        EXPECT_NEAR(sinCosOfTurn(x).sin, std::sin(2 * std::numbers::pi * x), 5e-7) << x;
        EXPECT_NEAR(sinCosOfTurn(x).cos, std::cos(2 * std::numbers::pi * x), 5e-7) << x;
    }
}

TEST(Warp, DiskIsUniformAndInverts) {
    EXPECT_NEAR(squareMean([](const Vec2& u) { return lengthSquared(Vec3(squareToDisk(u).x, squareToDisk(u).y, 0)); }),
                0.5, 1e-4);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return squareToDisk(u).length() < 0.5f; }), 0.25, 2e-3);
    EXPECT_EQ(squareToDisk(Vec2(0.5f, 0.5f)), Vec2(0, 0));
    EXPECT_EQ(squareToDisk(Vec2(1, 0.5f)), Vec2(1, 0));
    EXPECT_EQ(squareToDisk(Vec2(0.5f, 0)), Vec2(0, -1));
    EXPECT_EQ(squareMean([](const Vec2& u) { return (diskToSquare(squareToDisk(u)) - u).length() > 1e-6f; }), 0);
}

TEST(Warp, EqualAreaHemisphereIsUniform) {
    // Compares moments with those of the uniform distribution over the hemisphere.
    EXPECT_NEAR(squareMean([](const Vec2& u) { return squareToHemisphere(u).z; }), 0.5, 1e-4);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sqr(squareToHemisphere(u).z); }), 1 / 3.0, 1e-4);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sqr(squareToHemisphere(u).x); }), 1 / 3.0, 1e-4);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return squareToHemisphere(u).x * squareToHemisphere(u).y; }), 0, 1e-4);
    EXPECT_EQ(squareMean([](const Vec2& u) { return std::abs(length(squareToHemisphere(u)) - 1) > 1e-6f; }), 0);
}

TEST(Warp, EqualAreaTexelsHaveEqualSolidAngle) {
    // The Jacobian |dw/du x dw/dv| by finite differences. It must be 2 pi everywhere except on the diagonals, where it
    // is discontinuous.
    const float h = 1.f / 512;
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i) {
            const Vec2 c((i + 0.5f) / 32, (j + 0.3f) / 32);
            const Vec3 du = squareToHemisphere(c + Vec2(h, 0)) - squareToHemisphere(c - Vec2(h, 0));
            const Vec3 dv = squareToHemisphere(c + Vec2(0, h)) - squareToHemisphere(c - Vec2(0, h));
            EXPECT_NEAR(length(cross(du, dv)) / (4 * h * h), 2 * kPi, 0.02 * 2 * kPi) << i << ' ' << j;
        }
}

TEST(Warp, EqualAreaInverse) {
    EXPECT_EQ(
        squareMean([](const Vec2& u) { return (hemisphereToSquare(squareToHemisphere(u)) - u).length() > 1e-6f; }), 0);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 w = sampleUniformHemisphere(Vec2(uniformFloat(hash32(i, 0)), uniformFloat(hash32(i, 1))));
        EXPECT_NEAR(length(squareToHemisphere(hemisphereToSquare(w)) - w), 0, 1e-6);
    }
    // Poles, edges, corners, and directions slightly below the horizon.
    EXPECT_EQ(hemisphereToSquare(Vec3(0, 0, 1)), Vec2(0.5f, 0.5f));
    EXPECT_EQ(hemisphereToSquare(Vec3(1, 0, 0)), Vec2(1, 0.5f));
    EXPECT_EQ(hemisphereToSquare(Vec3(0, -1, 0)), Vec2(0.5f, 0));
    EXPECT_EQ(hemisphereToSquare(normalize(Vec3(-1, 0, -0.01f))), Vec2(0, 0.5f));
    EXPECT_EQ(squareToHemisphere(Vec2(1, 1)).z, 0);
    EXPECT_NEAR(squareToHemisphere(Vec2(1, 1)).x, std::sqrt(0.5f), 1e-6);
}

TEST(Warp, EqualAreaKeepsTheSquaresSymmetries) {
    for (int i = 0; i < 1000; ++i) {
        // Multiples of 2^-10, so that 1 - u is exact. The diagonals, where the two wedges meet, are left out.
        const Vec2 u(float(hash32(i, 0) % 1024) / 1024, float(hash32(i, 1) % 1024) / 1024);
        if (std::abs(2 * u.x - 1) == std::abs(2 * u.y - 1)) continue;
        const Vec3 w = squareToHemisphere(u);
        EXPECT_EQ(squareToHemisphere(Vec2(1 - u.x, u.y)), Vec3(-w.x, w.y, w.z));
        EXPECT_EQ(squareToHemisphere(Vec2(u.x, 1 - u.y)), Vec3(w.x, -w.y, w.z));
        EXPECT_EQ(squareToHemisphere(Vec2(u.y, u.x)), Vec3(w.y, w.x, w.z));
    }
}

TEST(Warp, DensitiesMatch) {
    // The expectation of g(w) / pdf(w) is the integral of g.
    auto cosine = [](const Vec2& u) {
        const Vec3 w = sampleCosineHemisphere(u);
        return sqr(w.z) / cosineHemispherePdf(w.z);
    };
    EXPECT_NEAR(squareMean(cosine), 2 * kPi / 3, 1e-3);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sampleCosineHemisphere(u).z; }), 2 / 3.0, 3e-4);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sqr(sampleUniformHemisphere(u).z); }), 1 / 3.0, 1e-4);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sqr(sampleUniformSphere(u).z); }), 1 / 3.0, 1e-4);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sampleUniformSphere(u).z; }), 0, 1e-6);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sampleUniformCone(u, 0.7f).z; }), 0.85, 1e-4);
    EXPECT_NEAR(1 / uniformConePdf(0.f), 2 * kPi, 1e-5);
    EXPECT_NEAR(uniformConePdf(-1.f), uniformSpherePdf(), 1e-7);
    EXPECT_NEAR(uniformConePdf(0.f), uniformHemispherePdf(), 1e-7);
    for (float c : {0.f, 0.9f, 0.9999f})
        EXPECT_EQ(squareMean([c](const Vec2& u) {
                      const Vec3 w = sampleUniformCone(u, c);
                      return std::abs(length(w) - 1) > 1e-6f || w.z < c - 1e-7f;
                  }),
                  0);
}

TEST(Warp, TriangleIsUniform) {
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sampleUniformTriangle(u).x; }), 1 / 3.0, 1e-4);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sampleUniformTriangle(u).y; }), 1 / 3.0, 1e-4);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sqr(sampleUniformTriangle(u).y); }), 1 / 6.0, 1e-4);
    EXPECT_NEAR(squareMean([](const Vec2& u) { return sampleUniformTriangle(u).x * sampleUniformTriangle(u).y; }),
                1 / 12.0, 1e-4);
}

}  // namespace
}  // namespace drc
