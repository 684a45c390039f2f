#include "scene/textures/texture_marble.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

Rgb at(const RgbTexturePtr& marble, const Vec3& p) {
    TextureContext context;
    context.p = p;
    return marble->eval(context);
}

TEST(Marble, LayersWithoutVariationAreKnown) {
    MarbleParams params;
    params.variation = 0;
    const auto marble = makeMarbleTexture(params, Mapping3D());
    // sin(y) = -1: the curve starts at the first colour. Nothing changes along x and z, which are parallel to the
    // layers.
    for (const float x : {0.f, 3.7f})
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(at(marble, Vec3(x, -kPi / 2, -x))[c], 1.5f * Rgb(0.58f, 0.58f, 0.6f)[c], 1e-4f);
    // sin(y) = 1: the curve ends at the last colour.
    EXPECT_NEAR(at(marble, Vec3(0, kPi / 2, 0)).x, 1.5f * 0.58f, 1e-4f);
    // y = 0, t = 1/2: the start of the fourth segment, which is its first colour.
    EXPECT_NEAR(at(marble, Vec3(0.f)).x, 1.5f * 0.5f, 1e-4f);
}

TEST(Marble, StaysWithinItsColoursAndHasTheBlueVein) {
    MarbleParams params;
    const auto marble = makeMarbleTexture(params, Mapping3D());
    Rgb least(10.f), most(0.f);
    for (int i = 0; i < 4000; ++i) {
        const float k = float(i) * 0.01f;
        const Rgb c = at(marble, Vec3(0.1f * k, k, 0.3f * k));
        for (int j = 0; j < 3; ++j) {
            least[j] = std::min(least[j], c[j]);
            most[j] = std::max(most[j], c[j]);
        }
    }
    EXPECT_GE(least.x, 1.5f * 0.2f);
    EXPECT_LE(most.x, 1.5f * 0.6f + 1e-4f);
    EXPECT_LT(least.x, 0.7f);
    EXPECT_GT(least.z, least.x + 0.1f);
}

TEST(Marble, ScaleIsThatOfTheWholeTexture) {
    MarbleParams params;
    params.scale = 4;
    const Vec3 p(0.3f, 0.2f, 0.7f);
    EXPECT_EQ(at(makeMarbleTexture(params, Mapping3D()), p),
              at(makeMarbleTexture({}, Mapping3D(Transform::scale(4, 4, 4))), p));
    EXPECT_TRUE(std::isfinite(at(makeMarbleTexture({}, Mapping3D()), Vec3(kInfinity, kInfinity, 0)).x));
}

}  // namespace
}  // namespace drc
