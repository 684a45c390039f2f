#include "scene/lobes/half_space_albedo.h"

#include <array>
#include <map>
#include <mutex>

#include "scene/lobes/fresnel.h"

namespace drc {
namespace {

// Number of directions (streams) per hemisphere. The first kHalf are beyond the critical angle, if there is one.
constexpr int kHalf = 8, kStreams = 2 * kHalf;
// Legendre terms of the phase function, of degrees 0 to kTerms - 1. The kHalf Gauss nodes on either side of the
// critical angle integrate each term exactly.
constexpr int kTerms = kStreams;

using Vector = std::array<double, kStreams>;
using Matrix = std::array<Vector, kStreams>;

Matrix identity() {
    Matrix m{};
    for (size_t i = 0; i < kStreams; ++i) m[i][i] = 1;
    return m;
}
Matrix operator*(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (size_t i = 0; i < kStreams; ++i)
        for (size_t k = 0; k < kStreams; ++k)
            for (size_t j = 0; j < kStreams; ++j) c[i][j] += a[i][k] * b[k][j];
    return c;
}
Matrix operator+(Matrix a, const Matrix& b) {
    for (size_t i = 0; i < kStreams; ++i)
        for (size_t j = 0; j < kStreams; ++j) a[i][j] += b[i][j];
    return a;
}
// The inverse of 1 - m. m describes reflections, which lose energy, so that Gauss-Jordan elimination needs no pivoting.
Matrix inverseOfOneMinus(const Matrix& m) {
    Matrix a = identity(), inverse = identity();
    for (size_t i = 0; i < kStreams; ++i)
        for (size_t j = 0; j < kStreams; ++j) a[i][j] -= m[i][j];
    for (size_t k = 0; k < kStreams; ++k) {
        const double scale = 1 / a[k][k];
        for (size_t j = 0; j < kStreams; ++j) {
            a[k][j] *= scale;
            inverse[k][j] *= scale;
        }
        for (size_t i = 0; i < kStreams; ++i) {
            const double factor = a[i][k];
            if (i == k || factor == 0) continue;
            for (size_t j = 0; j < kStreams; ++j) {
                a[i][j] -= factor * a[k][j];
                inverse[i][j] -= factor * inverse[k][j];
            }
        }
    }
    return inverse;
}

// Cosines of the streams, and quadrature weights that sum to one.
struct Streams {
    Vector cosine, weight;

    explicit Streams(double critical) {
        static constexpr double node[kHalf / 2] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                                   0.9602898564975363};
        static constexpr double gauss[kHalf / 2] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                                    0.1012285362903763};
        // Without a critical angle, any split of [0, 1] is as good.
        const double middle = critical > 0 ? critical : 0.5;
        const auto fill = [&](size_t first, double a, double b) {
            for (size_t i = 0; i < kHalf; ++i) {
                const size_t k = i / 2;
                cosine[first + i] = 0.5 * (a + b) + 0.5 * (b - a) * (i % 2 ? node[k] : -node[k]);
                weight[first + i] = 0.5 * (b - a) * gauss[k];
            }
        };
        fill(0, 0, middle);
        fill(kHalf, middle, 1);
    }
};

std::array<double, kTerms> legendre(double x) {
    std::array<double, kTerms> p{1, x};
    for (size_t l = 2; l < kTerms; ++l)
        p[l] = (double(2 * l - 1) * x * p[l - 1] - double(l - 1) * p[l - 2]) / double(l);
    return p;
}

// Scattering from stream j into stream i per unit of optical depth, for a single-scattering albedo of 1: up[i][j]
// reverses the vertical direction, on[i][j] keeps it.
struct Scattering {
    Matrix up{}, on{};
    double straight;  // share of the forward peak, which the streams cannot resolve; it counts as unscattered

    Scattering(double g, const Streams& streams) : straight(std::pow(g, kTerms)) {
        for (size_t i = 0; i < kStreams; ++i)
            for (size_t j = 0; j < kStreams; ++j) {
                const auto a = legendre(streams.cosine[i]), b = legendre(streams.cosine[j]);
                for (size_t l = 0; l < kTerms; ++l) {
                    // The Legendre moment without the forward peak (Wiscombe, "The Delta-M Method", 1977).
                    const double moment = (std::pow(g, double(l)) - straight) / (1 - straight);
                    const double term = 0.5 * double(2 * l + 1) * moment * a[l] * b[l] * streams.weight[j];
                    on[i][j] += term;
                    up[i][j] += l % 2 ? -term : term;
                }
            }
    }
};

// Reflection matrix of an infinitely deep medium without a boundary.
Matrix reflectionOf(double albedo, const Scattering& scattering, const Streams& streams) {
    // A layer so thin that light is scattered at most once is doubled until nothing comes through.
    constexpr double kThin = 0x1p-20, kThrough = 1e-9;
    constexpr int kMostDoublings = 60;
    const double scattered = albedo * (1 - scattering.straight) / (1 - albedo * scattering.straight);
    Matrix reflected{}, transmitted = identity();
    for (size_t i = 0; i < kStreams; ++i) {
        const double depth = kThin / streams.cosine[i];
        transmitted[i][i] -= depth;
        for (size_t j = 0; j < kStreams; ++j) {
            reflected[i][j] = scattered * scattering.up[i][j] * depth;
            transmitted[i][j] += scattered * scattering.on[i][j] * depth;
        }
    }
    for (int doubling = 0; doubling < kMostDoublings; ++doubling) {
        // `between` sums all paths that pass the first layer and bounce between both layers any number of times.
        const Matrix between = transmitted * inverseOfOneMinus(reflected * reflected);
        reflected = reflected + between * reflected * transmitted;
        transmitted = between * transmitted;
        double most = 0;
        for (const Vector& row : transmitted)
            for (const double t : row) most = std::max(most, t);
        if (most < kThrough) break;
    }
    return reflected;
}

// The nodes, in sqrt((1 - albedo) / (1 - g albedo)).
std::vector<float> nodes() {
    constexpr int kNodes = 33;
    std::vector<float> x;
    for (int i = 0; i < kNodes; ++i) x.push_back(float(i) / (kNodes - 1));
    return x;
}

}  // namespace

HalfSpaceAlbedo::HalfSpaceAlbedo(float g, float eta) : g_(g), nodes_(nodes()) {
    const double critical = std::sqrt(std::max(0.0, 1 - 1 / (double(eta) * eta)));
    const Streams streams(critical);
    const Scattering scattering(g, streams);
    Vector inside;  // reflectance of the boundary
    double entered = 0;
    for (size_t i = 0; i < kStreams; ++i) {
        inside[i] = fresnelDielectric(float(streams.cosine[i]), eta, 1);
        entered += streams.weight[i] * streams.cosine[i] * (1 - inside[i]);
    }
    shares_.push_back(1);  // nothing is absorbed
    for (int k = 1; k < nodes_.size(); ++k) {
        const double s2 = double(nodes_[k]) * nodes_[k];
        const Matrix reflected = reflectionOf((1 - s2) / (1 - g * s2), scattering, streams);
        Matrix returned = reflected;
        for (Vector& row : returned)
            for (size_t j = 0; j < kStreams; ++j) row[j] *= inside[j];
        const Matrix up = inverseOfOneMinus(returned) * reflected;
        double left = 0;
        for (size_t i = 0; i < kStreams; ++i)
            for (size_t j = 0; j < kStreams; ++j)
                left += streams.weight[i] * streams.cosine[i] * (1 - inside[i]) * up[i][j] * (1 - inside[j]);
        shares_.push_back(float(std::clamp(left / entered, 0.0, 1.0)));
    }
}

float HalfSpaceAlbedo::operator()(float scattering) const {
    const float albedo = std::clamp(scattering, 0.f, 1.f);
    const SplineWeights at = nodes_.at(std::sqrt((1 - albedo) / (1 - g_ * albedo)));
    float share = 0;
    for (int i = 0; i < 4; ++i)
        if (at.weight[size_t(i)] != 0) share += at.weight[size_t(i)] * shares_[size_t(at.node(i))];
    return std::clamp(share, 0.f, 1.f);
}

std::shared_ptr<const HalfSpaceAlbedo> halfSpaceAlbedo(float g, float eta) {
    static std::mutex mutex;
    static std::map<std::pair<float, float>, std::weak_ptr<const HalfSpaceAlbedo>> known;
    const std::lock_guard lock(mutex);
    std::weak_ptr<const HalfSpaceAlbedo>& entry = known[{g, eta}];
    std::shared_ptr<const HalfSpaceAlbedo> found = entry.lock();
    if (!found) entry = found = std::make_shared<const HalfSpaceAlbedo>(g, eta);
    return found;
}

}  // namespace drc
