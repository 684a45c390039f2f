#include "scene/lobes/lambert_transmission.h"

#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

const LambertTransmission kLobe(Rgb(0.2f, 0.5f, 0.9f));

TEST(LambertTransmission, Sampling) { checkSampling(kLobe); }

TEST(LambertTransmission, AlbedoIsExact) { checkAlbedo(kLobe, 1e-4f); }

TEST(LambertTransmission, IsSeparable) { checkSeparable(kLobe); }

TEST(LambertTransmission, Energy) { checkEnergy(LambertTransmission(Rgb(1.f)), 1e-4f); }

TEST(LambertTransmission, Value) { EXPECT_NEAR(kLobe.f(direction(0.3f), direction(0.6f)).y, 0.5f * kInvPi, 1e-7f); }

}  // namespace
}  // namespace drc
