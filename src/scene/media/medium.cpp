#include "scene/media/medium.h"

namespace drc {

Rgb Medium::emitted(float distance) const {
    Rgb sum(0.f);
    if (isBlack(emission)) return sum;
    const Rgb t = sigmaT();
    // expm1, because 1 - exp(-x) suffers from cancellation in thin media.
    for (int c = 0; c < 3; ++c)
        if (sigmaA[c] > 0) sum[c] = emission[c] * sigmaA[c] / t[c] * -std::expm1(-t[c] * distance);
    return sum;
}

Rgb Medium::albedo() const {
    const Rgb t = sigmaT();
    Rgb result(0.f);
    for (int c = 0; c < 3; ++c) result[c] = t[c] > 0 ? sigmaS[c] / t[c] : 0;
    return result;
}

}  // namespace drc
