#include "maps/network_map_denoiser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "maps/example_testing.h"

namespace drc {
namespace {

const MapLayout kLayout(Projection::EqualArea, 16);

// A network whose output is the same everywhere, whatever it sees.
std::shared_ptr<const UNetWeights> constantNetwork(int inputs) {
    const UNetShape shape{.width = 4, .levels = 2, .size = 16, .inputs = inputs};
    auto convs = UNetWeights::random(shape, 1)->convs();
    for (UNetWeights::Conv& conv : convs) {
        std::fill(conv.weight.begin(), conv.weight.end(), 0.f);
        std::fill(conv.bias.begin(), conv.bias.end(), 0.2f);
    }
    return std::make_shared<UNetWeights>(shape, std::move(convs));
}

double mean(const std::vector<float>& radiance, size_t channel) {
    double sum = 0;
    for (size_t i = 0; i < 256; ++i) sum += radiance[channel * 256 + i] / 256.;
    return sum;
}

// What such a network gives is even light on the surfaces seen: radiance in proportion to their albedos.
TEST(NetworkMapDenoiser, GivesTheLightThatFallsOntoSurfacesIfItSeesGuides) {
    const auto mapDenoiser = makeNetworkMapDenoiser(constantNetwork(kGuidedPlanes), kLayout, Precision::Fp32);
    CapturedMap map = randomExample(kLayout, 1, 3).inputs.front();
    const CapturedMap before = map;
    mapDenoiser->denoise({&map, 1}, kLayout);
    for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(mean(map.radiance, c) / mean(before.radiance, c), 1, 1e-4);
        const float unit = map.radiance[c * 256] / (map.albedo[c * 256] + 0.05f);
        for (size_t i = c * 256; i < (c + 1) * 256; ++i)
            EXPECT_NEAR(map.radiance[i], unit * (map.albedo[i] + 0.05f), 1e-4f * unit);
    }
    EXPECT_EQ(map.albedo, before.albedo);
}

TEST(NetworkMapDenoiser, DoesNotAskForWhatTheNetworkDoesNotSee) {
    const auto mapDenoiser = makeNetworkMapDenoiser(constantNetwork(kPlainPlanes), kLayout, Precision::Fp32);
    CapturedMap map = randomExample(kLayout, 1, 3).inputs.front();
    const double energy = mean(map.radiance, 1);
    map.albedo.clear();
    map.direct.clear();
    mapDenoiser->denoise({&map, 1}, kLayout);
    for (size_t i = 256; i < 512; ++i) EXPECT_NEAR(map.radiance[i], energy, 1e-4 * energy);
}

TEST(NetworkMapDenoiser, RefusesMapsWithoutWhatItNeeds) {
    const auto mapDenoiser = makeNetworkMapDenoiser(constantNetwork(kGuidedPlanes), kLayout, Precision::Fp32);
    CapturedMap map = randomExample(kLayout, 1, 3).inputs.front();
    map.direct.clear();
    try {
        mapDenoiser->denoise({&map, 1}, kLayout);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("have none"));
    }
}

}  // namespace
}  // namespace drc
