#include "scene/textures/bump.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

// A texture with the height a u + b v + c.
class Plane final : public FloatTexture {
  public:
    Plane(float a, float b, float c) : a_(a), b_(b), c_(c) {}
    float eval(const TextureContext& at) const override { return a_ * at.uv.x + b_ * at.uv.y + c_; }

  private:
    float a_, b_, c_;
};

TextureContext contextFor(const Frame& frame) {
    TextureContext at;
    at.p = Vec3(1, 2, 3);
    at.n = frame.n;
    at.uv = Vec2(0.25f, 0.5f);
    at.dpdu = frame.s * 2;
    at.dpdv = frame.t * 4;
    at.uvFootprint = 0.01f;
    return at;
}

TEST(Bump, SlopeTiltsTheNormal) {
    const Frame frame = Frame::fromNormal(normalize(Vec3(0.3f, 0.2f, -0.9f)));
    // Slopes per unit length: 0.6 / 2 along s and -0.8 / 4 along t.
    const Frame bumped = bumpFrame(contextFor(frame), frame, Plane(0.6f, -0.8f, 0.1f));
    const Vec3 expected = normalize(frame.n - frame.s * 0.3f + frame.t * 0.2f);
    EXPECT_LT(length(bumped.n - expected), 1e-4f);
    EXPECT_NEAR(length(bumped.s), 1, 1e-5f);
    EXPECT_NEAR(dot(bumped.s, bumped.n), 0, 1e-5f);
    EXPECT_LT(length(cross(bumped.n, bumped.s) - bumped.t), 1e-5f);
    EXPECT_GT(dot(bumped.s, frame.s), 0);
}

TEST(Bump, KeepsTheSideOfTheShadingNormal) {
    // dpdu x dpdv points away from the normal, as on a surface of reversed orientation.
    const Frame frame = Frame::fromNormal(Vec3(0, 0, 1));
    TextureContext at = contextFor(frame);
    std::swap(at.dpdu, at.dpdv);
    const Frame bumped = bumpFrame(at, frame, Plane(0.4f, 0, 0));
    EXPECT_LT(length(bumped.n - normalize(frame.n - frame.t * 0.1f)), 1e-4f);
}

TEST(Bump, FlatHeightsChangeNothing) {
    const Frame frame = Frame::fromNormal(normalize(Vec3(0.3f, 0.2f, 0.9f)));
    TextureContext at = contextFor(frame);
    // As on a triangle that is not perpendicular to the shading normal.
    at.dpdu += frame.n * 0.5f;
    EXPECT_LT(length(bumpFrame(at, frame, Plane(0, 0, 5)).n - frame.n), 1e-5f);
    at.dpdu = at.dpdv = Vec3(0.f);
    EXPECT_EQ(bumpFrame(at, frame, Plane(1, 1, 0)).n, frame.n);
    EXPECT_EQ(bumpFrame(contextFor(frame), frame, ConstantTexture<float>(3)).s, frame.s);
}

TEST(Bump, HeightOverACurvedSurface) {
    // A sphere of radius r, raised by a constant, keeps its normals.
    const Frame frame;
    TextureContext at = contextFor(frame);
    at.dpdu = Vec3(2, 0, 0);
    at.dpdv = Vec3(0, 2, 0);
    const Frame bumped = bumpFrame(at, frame, Plane(0, 0, 0.5f), Vec3(1, 0, 0), Vec3(0, 1, 0));
    EXPECT_LT(length(bumped.n - frame.n), 1e-5f);
    // A slope is measured along the raised surface, which is larger: 1 / (2 + 0.5).
    const Frame tilted = bumpFrame(at, frame, Plane(1, 0, 0.25f), Vec3(1, 0, 0), Vec3(0, 1, 0));
    EXPECT_NEAR(-tilted.n.x / tilted.n.z, 0.4f, 1e-3f);
}

// The map of a plane's normals is that of its heights, on either side of a surface and in texture coordinates of both
// hands.
TEST(NormalMap, IsTheBumpMapOfItsHeights) {
    for (const float side : {1.f, -1.f})
        for (const float hand : {1.f, -1.f}) {
            const Frame frame = Frame::fromNormal(normalize(Vec3(0.3f, 0.2f, -0.9f)) * side);
            TextureContext at = contextFor(frame);
            at.dpdv *= hand;
            // Slopes per unit length: 0.6 / 2 along u and -0.8 / 4 along v.
            const Vec3 n = normalize(Vec3(-0.3f, 0.2f, 1));
            const ConstantTexture<Rgb> map(Rgb(0.5f + 0.5f * n.x, 0.5f + 0.5f * n.y, 0.5f + 0.5f * n.z));
            const Frame bumped = bumpFrame(at, frame, Plane(0.6f, -0.8f, 0.1f)),
                        mapped = normalMapFrame(at, frame, map);
            EXPECT_LT(length(bumped.n - mapped.n), 1e-4f) << side << hand;
            EXPECT_NEAR(dot(mapped.s, mapped.n), 0, 1e-5f);
            EXPECT_GT(dot(mapped.s, frame.s), 0.9f);
        }
}

TEST(NormalMap, SaysNothingWhereItHasNoNormal) {
    const Frame frame = Frame::fromNormal(normalize(Vec3(0.3f, 0.2f, -0.9f)));
    const auto mapped = [&](const Rgb& color) {
        return normalMapFrame(contextFor(frame), frame, ConstantTexture<Rgb>(color));
    };
    EXPECT_LT(length(mapped(Rgb(0.5f, 0.5f, 1)).n - frame.n), 1e-6f);
    for (const Rgb& color : {Rgb(0.5f), Rgb(0.f), Rgb(0.7f, 0.5f, 0.2f), Rgb(NAN)})
        EXPECT_EQ(mapped(color).n, frame.n) << color;
}

}  // namespace
}  // namespace drc
