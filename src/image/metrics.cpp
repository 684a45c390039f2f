#include "image/metrics.h"

#include <fmt/core.h>

#include <cmath>

#include "image/block_means.h"
#include "image/flip.h"
#include "image/png.h"
#include "image/relmse.h"
#include "image/ssim.h"

namespace drc {

Image exposed(const Image& image, float stops) {
    Image result = image.toRgb();
    const float factor = std::exp2(stops);
    for (float& v : result.data()) v *= factor;
    return result;
}

Metrics compare(const Image& reference, const Image& test, float exposure) {
    Metrics m;
    const RadianceErrors errors = radianceErrors(reference, test);
    m.relmse = errors.relmse, m.mse = errors.mse, m.l1 = errors.l1;
    m.meanRatio = errors.meanRatio;
    m.nonFiniteReference = errors.nonFiniteReference, m.nonFiniteTest = errors.nonFiniteTest;
    m.blockRelmse = radianceErrors(blockMeans(reference, kComparedBlock), blockMeans(test, kComparedBlock)).relmse;
    const Image r = exposed(reference, exposure), t = exposed(test, exposure);
    m.ssim = ssim(r, t);
    m.flip = flip(r, t);
    m.pngKb = {double(encodePng(r).size()) / 1000, double(encodePng(t).size()) / 1000};
    return m;
}

}  // namespace drc
