#include "scene/lobes/cosine_curve.h"

namespace drc {
namespace {

// With c = t^2, the integral of 2 c f(c) dc is that of 4 t^3 f dt. As f is linear in t on each cell [a, a + h], the
// weight of either end is the integral of 4 t^3 times the end's linear weight.
constexpr std::array<float, CosineCurve::kNodes> meanWeights() {
    std::array<float, CosineCurve::kNodes> weights{};
    constexpr int kCells = CosineCurve::kNodes - 1;
    constexpr double h = 1.0 / kCells;
    for (int i = 0; i < kCells; ++i) {
        const double a = i * h;
        // `whole` is the integral of 4 h (a + h s)^3 over s in [0, 1], `right` that of 4 h s (a + h s)^3.
        const double whole = 4 * h * (a * a * a + 1.5 * a * a * h + a * h * h + h * h * h / 4);
        const double right = 4 * h * (a * a * a / 2 + a * a * h + 0.75 * a * h * h + h * h * h / 5);
        weights[size_t(i)] += float(whole - right);
        weights[size_t(i) + 1] += float(right);
    }
    return weights;
}

}  // namespace

float CosineCurve::mean() const {
    static constexpr auto kWeights = meanWeights();
    float sum = 0;
    for (int i = 0; i < kNodes; ++i) sum += kWeights[size_t(i)] * values_[size_t(i)];
    return sum;
}

}  // namespace drc
