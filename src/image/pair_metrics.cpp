#include "image/pair_metrics.h"

#include <fmt/core.h>

#include <cstring>
#include <utility>

#include "base/error.h"
#include "image/flip.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "image/relative_norm.h"
#include "image/ssim.h"

namespace drc {
namespace {

void requireSize(const Image& a, const std::string& aName, const Image& b, const std::string& bName) {
    if (a.width() != b.width() || a.height() != b.height())
        throw Error(
            fmt::format("the images differ in size: {} is {}, {} is {}", aName, sizeString(a), bName, sizeString(b)));
}

// Bit by bit: NaN equals itself here.
bool samePicture(const Image& a, const Image& b) {
    return a.data().size() == b.data().size() &&
           std::memcmp(a.data().data(), b.data().data(), a.data().size() * sizeof(float)) == 0;
}

double pngKb(const Image& image) { return double(encodePng(image).size()) / 1000; }

}  // namespace

ReferencePair::ReferencePair(Image first, Image second, float exposure, const std::string& firstName,
                             const std::string& secondName)
    : first_(first.toRgb()),
      second_(second.toRgb()),
      exposure_(exposure),
      firstName_(firstName),
      secondName_(secondName) {
    requireSize(first_, firstName_, second_, secondName_);
    if (samePicture(first_, second_))
        throw Error(fmt::format("{} and {} are the same picture: give two references of different seeds, or one alone",
                                firstName_, secondName_));
    norm_ = relativeNorm(first_, second_);
    mean_ = first_;
    for (size_t i = 0; i < mean_.data().size(); ++i) mean_.data()[i] = (first_.data()[i] + second_.data()[i]) / 2;
    shown_ = exposed(mean_, exposure);
    const Image a = exposed(first_, exposure), b = exposed(second_, exposure);
    ssimNoise_ = (1 - ssim(a, b)) / 4;
    flipNoise_ = flip(a, b) / 2;
    pngKb_ = pngKb(shown_);
}

PairMetrics ReferencePair::compare(const Image& test, const std::string& testName) const {
    const Image t = test.toRgb();
    requireSize(first_, firstName_, t, testName);
    for (const auto& [reference, name] : {std::pair(&first_, &firstName_), std::pair(&second_, &secondName_)})
        if (samePicture(*reference, t))
            throw Error(
                fmt::format("{} is the same picture as {}: a picture cannot be measured by itself", testName, *name));
    PairMetrics m;
    m.errors = crossErrors(first_, second_, norm_, t);
    const Image shown = exposed(t, exposure_);
    m.ssim = ssim(shown_, shown);
    m.flip = flip(shown_, shown);
    m.ssimIsNoisy = ssimNoise_ > kMostDisplayedNoise * (1 - m.ssim);
    m.flipIsNoisy = flipNoise_ > kMostDisplayedNoise * m.flip;
    m.pngKb = {pngKb_, pngKb(shown)};
    return m;
}

}  // namespace drc
