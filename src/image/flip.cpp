#include "image/flip.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "base/parallel.h"
#include "image/color.h"

namespace drc {
namespace {

// Section 4: exponents and the knee that maps colour differences to [0, 1].
constexpr float kColorExponent = 0.7f;
constexpr float kKneeIn = 0.4f, kKneeOut = 0.95f;
constexpr float kFeatureExponent = 0.5f;
constexpr float kFeatureWidth = 0.082f;  // degrees

// One term a sqrt(pi / b) exp(-pi^2 x^2 / b) of a contrast sensitivity function in the image's domain; x in degrees.
struct CsfTerm {
    float a, b;
};
constexpr CsfTerm kLuminanceCsf{1, 0.0047f}, kRedGreenCsf{1, 0.0053f};
constexpr CsfTerm kBlueYellowCsf[2] = {{34.1f, 0.04f}, {13.5f, 0.025f}};
constexpr float kWidestB = 0.04f;

// The opponent space YyCxCz: a linear relative of L*a*b*, in which filtering is meaningful.
using Opponent = std::array<Plane, 3>;

Opponent toOpponent(const Image& image) {
    Opponent planes;
    for (auto& p : planes) p = Plane(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Vec3 v = rgbToXyz(clamp01(image.rgb(x, y))) / kWhiteXyz;
            planes[0].at(x, y) = 116 * v.y - 16;
            planes[1].at(x, y) = 500 * (v.x - v.y);
            planes[2].at(x, y) = 200 * (v.y - v.z);
        }
    }
    return planes;
}

Rgb fromOpponent(float yy, float cx, float cz) {
    const float y = (yy + 16) / 116;
    return xyzToRgb(Vec3(y + cx / 500, y, y - cz / 200) * kWhiteXyz);
}

Kernel csfKernel(float b, float pixelsPerDegree, int radius) {
    return gaussianKernel(std::sqrt(b / 2) / kPi * pixelsPerDegree, radius);
}

// The integral of a term over the pixels of its filter, up to a factor common to both terms.
float termWeight(const CsfTerm& term, float pixelsPerDegree, int radius) {
    float sum = 0;
    for (int i = -radius; i <= radius; ++i) {
        const float x = float(i) / pixelsPerDegree;
        sum += std::exp(-kPi * kPi * x * x / term.b);
    }
    return term.a * std::sqrt(kPi / term.b) * sum * sum;
}

// Section 4.1: removes detail that the eye cannot resolve at this distance.
Opponent filterByContrastSensitivity(const Opponent& in, float pixelsPerDegree) {
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidestB / (2 * kPi * kPi)) * pixelsPerDegree));
    const Kernel luminance = csfKernel(kLuminanceCsf.b, pixelsPerDegree, radius);
    const Kernel redGreen = csfKernel(kRedGreenCsf.b, pixelsPerDegree, radius);
    Opponent out;
    out[0] = convolve(in[0], luminance, luminance);
    out[1] = convolve(in[1], redGreen, redGreen);
    // A sum of two Gaussians is not separable; each of them is.
    out[2] = Plane(in[2].width, in[2].height);
    const float total =
        termWeight(kBlueYellowCsf[0], pixelsPerDegree, radius) + termWeight(kBlueYellowCsf[1], pixelsPerDegree, radius);
    for (const CsfTerm& term : kBlueYellowCsf) {
        const Kernel kernel = csfKernel(term.b, pixelsPerDegree, radius);
        const Plane part = convolve(in[2], kernel, kernel);
        const float weight = termWeight(term, pixelsPerDegree, radius) / total;
        for (size_t i = 0; i < part.values.size(); ++i) out[2].values[i] += weight * part.values[i];
    }
    return out;
}

// L*a*b* whose chroma fades with lightness (the Hunt effect).
Vec3 huntLab(const Rgb& c) {
    const Vec3 lab = rgbToLab(c);
    return Vec3(lab.x, 0.01f * lab.x * lab.y, 0.01f * lab.x * lab.z);
}

// Distance for large colour differences: city block between lightness and chroma, Euclidean within chroma.
float hyab(const Vec3& a, const Vec3& b) { return std::abs(a.x - b.x) + std::sqrt(sqr(a.y - b.y) + sqr(a.z - b.z)); }

float colorDifference(const Vec3& a, const Vec3& b) {
    static const float kLargest = std::pow(hyab(huntLab(Rgb(0, 1, 0)), huntLab(Rgb(0, 0, 1))), kColorExponent);
    const float d = std::pow(hyab(a, b), kColorExponent), knee = kKneeIn * kLargest;
    return d < knee ? kKneeOut * d / knee : kKneeOut + (d - knee) / (kLargest - knee) * (1 - kKneeOut);
}

// Makes the positive weights sum to 1 and the negative ones to -1.
void normaliseBySign(Kernel& kernel) {
    float positive = 0, negative = 0;
    for (const float w : kernel) (w > 0 ? positive : negative) += w;
    for (float& w : kernel) w /= w > 0 ? positive : -negative;
}

struct Features {
    Plane edges, points;
};

Plane gradientMagnitude(const Plane& luminance, const Kernel& derivative, const Kernel& smooth) {
    Plane result = convolve(luminance, derivative, smooth);
    const Plane alongY = convolve(luminance, smooth, derivative);
    for (size_t i = 0; i < result.values.size(); ++i) result.values[i] = std::hypot(result.values[i], alongY.values[i]);
    return result;
}

// Section 4.2: edges by the first, points by the second derivative of a Gaussian of the feature's width.
Features findFeatures(const Plane& opponentLuminance, float pixelsPerDegree) {
    Plane luminance = opponentLuminance;
    for (float& v : luminance.values) v = (v + 16) / 116;
    const float sigma = 0.5f * kFeatureWidth * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const Kernel smooth = gaussianKernel(sigma, radius);
    Kernel first = smooth, second = smooth;
    for (int i = -radius; i <= radius; ++i) {
        first[size_t(i + radius)] *= -float(i);
        second[size_t(i + radius)] *= sqr(float(i) / sigma) - 1;
    }
    normaliseBySign(first);
    normaliseBySign(second);
    return {gradientMagnitude(luminance, first, smooth), gradientMagnitude(luminance, second, smooth)};
}

}  // namespace

Plane flipMap(const Image& reference, const Image& test, float pixelsPerDegree) {
    requireSameSize(reference, test);
    const Opponent opponentR = toOpponent(reference), opponentT = toOpponent(test);
    const Features featuresR = findFeatures(opponentR[0], pixelsPerDegree);
    const Features featuresT = findFeatures(opponentT[0], pixelsPerDegree);
    const Opponent r = filterByContrastSensitivity(opponentR, pixelsPerDegree);
    const Opponent t = filterByContrastSensitivity(opponentT, pixelsPerDegree);

    Plane map(reference.width(), reference.height());
    constexpr int kPixelsPerPiece = 4096;
    parallelFor(0, static_cast<int>(map.values.size()), kPixelsPerPiece, [&](int begin, int end) {
        for (size_t i = size_t(begin); i < size_t(end); ++i) {
            // Filtering may leave the gamut of the monitor, which shows nothing outside it.
            const Rgb cr = clamp01(fromOpponent(r[0].values[i], r[1].values[i], r[2].values[i]));
            const Rgb ct = clamp01(fromOpponent(t[0].values[i], t[1].values[i], t[2].values[i]));
            const float color = colorDifference(huntLab(cr), huntLab(ct));
            const float edge = std::abs(featuresR.edges.values[i] - featuresT.edges.values[i]);
            const float point = std::abs(featuresR.points.values[i] - featuresT.points.values[i]);
            const float feature = std::pow(std::max(edge, point) / std::sqrt(2.f), kFeatureExponent);
            map.values[i] = std::pow(color, 1 - feature);
        }
    });
    return map;
}

double flip(const Image& reference, const Image& test, float pixelsPerDegree) {
    const Plane map = flipMap(reference, test, pixelsPerDegree);
    return std::accumulate(map.values.begin(), map.values.end(), 0.0) / double(map.values.size());
}

}  // namespace drc
