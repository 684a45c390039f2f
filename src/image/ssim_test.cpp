#include "image/ssim.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/test_images.h"

namespace drc {
namespace {

TEST(Ssim, IsOneForTheSameImage) { EXPECT_NEAR(ssim(testing_images::changed(), testing_images::changed()), 1, 1e-6); }

// scikit-image 0.26 on the sRGB-encoded images' luminance (0.212671, 0.715160, 0.072169): structural_similarity(
// gaussian_weights=True, sigma=1.5, use_sample_covariance=False, data_range=1, win_size=11) gives 0.91666022.
TEST(Ssim, AgreesWithScikitImage) {
    EXPECT_NEAR(ssim(testing_images::reference(), testing_images::changed()), 0.91666022, 2e-5);
}

// Two constant images have no variance: what is left is (2 a b + C1) / (a^2 + b^2 + C1), with a and b sRGB-encoded.
TEST(Ssim, ConstantImagesByHand) {
    Image a(11, 11), b(11, 11);
    for (float& v : a.data()) v = 0.0497068f;  // encodes to 0.24742
    for (float& v : b.data()) v = 7;           // clamped to 1
    const double e = 1.055 * std::pow(0.0497068, 1 / 2.4) - 0.055;
    EXPECT_NEAR(ssim(a, b), (2 * e + 1e-4) / (e * e + 1 + 1e-4), 1e-4);
}

TEST(Ssim, SizesThatCannotBe) {
    EXPECT_TRUE(std::isnan(ssim(Image(10, 40), Image(10, 40))));
    EXPECT_THROW(ssim(Image(20, 40), Image(40, 20)), Error);
}

}  // namespace
}  // namespace drc
