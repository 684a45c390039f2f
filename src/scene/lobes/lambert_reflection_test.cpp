#include "scene/lobes/lambert_reflection.h"

#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

const LambertReflection kLobe(Rgb(0.2f, 0.5f, 0.9f));

TEST(LambertReflection, Sampling) { checkSampling(kLobe); }

TEST(LambertReflection, AlbedoIsExact) { checkAlbedo(kLobe, 1e-4f); }

TEST(LambertReflection, IsSeparable) { checkSeparable(kLobe); }

TEST(LambertReflection, EnergyAndReciprocity) {
    checkEnergy(LambertReflection(Rgb(1.f)), 1e-4f);
    checkReciprocity(kLobe);
}

TEST(LambertReflection, Value) { EXPECT_NEAR(kLobe.f(direction(0.3f), direction(0.6f)).y, 0.5f * kInvPi, 1e-7f); }

}  // namespace
}  // namespace drc
