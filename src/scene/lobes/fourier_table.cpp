#include "scene/lobes/fourier_table.h"

#include <algorithm>

#include "base/parallel.h"
#include "scene/lobes/equivalent_alpha.h"

namespace drc {
namespace {

// dotProduct() accumulates this many independent partial sums, which fit a SIMD register.
constexpr int kLanes = 8;
// Number of orders k for which cos(k azimuth) is computed at a time.
constexpr int kChunk = 64;

float dotProduct(const float* a, const float* b, int count) {
    float lanes[kLanes] = {};
    int k = 0;
    for (; k + kLanes <= count; k += kLanes)
        for (int i = 0; i < kLanes; ++i) lanes[i] += a[k + i] * b[k + i];
    float sum = 0;
    for (const float lane : lanes) sum += lane;
    for (; k < count; ++k) sum += a[k] * b[k];
    return sum;
}

// The sum of a_k cos(k azimuth), by Clenshaw's recurrence.
double seriesAt(const float* a, uint32_t orders, double cosAzimuth) {
    double b1 = 0, b2 = 0;
    for (uint32_t k = orders; k-- > 1;) {
        const double b = a[k] + 2 * cosAzimuth * b1 - b2;
        b2 = b1;
        b1 = b;
    }
    return orders > 0 ? a[0] + cosAzimuth * b1 - b2 : 0;
}

// RGB from a file's channels, which are luminance, red and blue; green follows from the luminance.
Rgb toRgb(float y, float r, float b) { return Rgb(r, (y - 0.212671f * r - 0.072169f * b) / 0.715160f, b); }

}  // namespace

// Smallest and largest value of one series over all azimuths.
struct FourierTable::Extremes {
    float least = 0, largest = 0;
};

FourierTable::FourierTable(FourierSeries series) : series_(std::move(series)), nodes_(series_.cosines) {
    findSides();
    integrateAlbedo();
    const std::vector<Extremes> extremes = findExtremes();
    findAlpha(extremes);
    raise(extremes);
    accumulate();
}

int FourierTable::sideOf(int node) const {
    const float mu = nodes_[node];
    if (mu != 0) return mu < 0 ? -1 : 1;
    if (node + 1 < nodes_.size() && nodes_[node + 1] == 0) return -1;
    return node > 0 && nodes_[node - 1] == 0 ? 1 : 0;
}

void FourierTable::findSides() {
    for (int o = 0; o < nodes_.size(); ++o)
        for (int i = 0; i < nodes_.size(); ++i) {
            if (!(mean(pair(o, i)) > 0)) continue;
            reflects_ = reflects_ || nodes_[i] * nodes_[o] < 0;
            transmits_ = transmits_ || nodes_[i] * nodes_[o] > 0;
        }
    // Series of a side that receives no light contain only noise, and are removed.
    for (int o = 0; o < nodes_.size(); ++o)
        for (int i = 0; i < nodes_.size(); ++i)
            if (!isPossible(sideOf(i), sideOf(o))) series_.orders[pair(o, i)] = 0;
}

void FourierTable::integrateAlbedo() {
    const std::vector<double> weights = nodes_.integralWeights();
    albedo_.resize(size_t(nodes_.size()));
    for (int o = 0; o < nodes_.size(); ++o) {
        double sum[3] = {};
        for (int i = 0; i < nodes_.size(); ++i) {
            const size_t p = pair(o, i);
            if (series_.orders[p] == 0) continue;
            for (int c = 0; c < series_.channels; ++c)
                sum[c] += 2 * std::numbers::pi * weights[size_t(i)] * series(p)[size_t(c) * series_.orders[p]];
        }
        albedo_[size_t(o)] =
            series_.channels == 1 ? Rgb(float(sum[0])) : toRgb(float(sum[0]), float(sum[1]), float(sum[2]));
    }
}

std::vector<FourierTable::Extremes> FourierTable::findExtremes() const {
    // With four azimuths per order, parabolas through three neighbouring values find the dips of the highest order.
    // Beyond kMostAzimuths, dips that lie between the azimuths are noise.
    constexpr uint32_t kMostAzimuths = 512;
    std::vector<Extremes> found(size_t(nodes_.size()) * size_t(nodes_.size()));
    parallelFor(0, int(found.size()), nodes_.size(), [&](int begin, int end) {
        std::vector<double> values;
        for (size_t p = size_t(begin); p < size_t(end); ++p) {
            const uint32_t orders = series_.orders[p];
            if (orders == 0) continue;
            const uint32_t steps = orders > 1 ? std::min(4 * orders, kMostAzimuths) : 1;
            values.clear();
            for (uint32_t k = 0; k <= steps; ++k)
                values.push_back(seriesAt(series(p), orders, std::cos(std::numbers::pi * k / steps)));
            const auto [least, largest] = std::minmax_element(values.begin(), values.end());
            double dip = *least;
            for (size_t k = 1; k + 1 < values.size(); ++k) {
                const double before = values[k - 1] - values[k], after = values[k + 1] - values[k];
                if (before > 0 && after > 0)
                    dip = std::min(dip, values[k] - (before - after) * (before - after) / (8 * (before + after)));
            }
            found[p] = {float(dip), float(*largest)};
        }
    });
    return found;
}

void FourierTable::findAlpha(const std::vector<Extremes>& extremes) {
    // Series of few terms are negative at grazing angles, where they should be small.
    constexpr float kLeastCosine = 0.1f;
    for (int o = 0; o < nodes_.size(); ++o) {
        const float energy = luminance(albedo_[size_t(o)]), cosine = std::abs(nodes_[o]);
        if (!(energy > 0) || cosine < kLeastCosineOfAlpha) continue;
        for (const float side : {-1.f, 1.f}) {
            float largest = 0, diffuse = kInfinity;
            for (int i = 0; i < nodes_.size(); ++i) {
                if (!(nodes_[i] * side > 0)) continue;
                const Extremes& e = extremes[pair(o, i)];
                largest = std::max(largest, e.largest / energy);
                if (std::abs(nodes_[i]) >= kLeastCosine)
                    diffuse = std::min(diffuse, kPi * e.least / (std::abs(nodes_[i]) * energy));
            }
            if (largest > 0) alpha_ = std::min(alpha_, equivalentAlpha(cosine, largest, std::clamp(diffuse, 0.f, 1.f)));
        }
    }
}

void FourierTable::raise(const std::vector<Extremes>& extremes) {
    // Each series is raised by at least this share of the largest mean among its neighbours. Where only the outer nodes
    // of both splines carry light, its weight is a product of two negative weights, about 0.005 at most.
    constexpr float kSpread = 0.005f;
    const int n = nodes_.size();
    raise_.resize(extremes.size());
    for (int o = 0; o < n; ++o)
        for (int i = 0; i < n; ++i) {
            if (!isPossible(sideOf(i), sideOf(o))) continue;
            float neighbours = 0;
            for (int oo = std::max(0, o - 1); oo <= std::min(n - 1, o + 1); ++oo)
                for (int ii = std::max(0, i - 1); ii <= std::min(n - 1, i + 1); ++ii)
                    neighbours = std::max(neighbours, mean(pair(oo, ii)));
            raise_[pair(o, i)] = std::max(-extremes[pair(o, i)].least, kSpread * neighbours);
        }
}

void FourierTable::accumulate() {
    cumulative_.resize(raise_.size());
    for (int o = 0; o < nodes_.size(); ++o) {
        double sum = 0;
        for (int i = 1; i < nodes_.size(); ++i) {
            const size_t p = pair(o, i);
            sum += 0.5 * (double(nodes_[i]) - nodes_[i - 1]) * (double(sampledMean(p - 1)) + sampledMean(p));
            cumulative_[p] = float(sum);
        }
    }
}

FourierTable::Rows FourierTable::rowsAt(float outgoing) const {
    const SplineWeights at = nodes_.at(outgoing);
    return {at, (1 - at.t) * total(at.segment), at.t * total(at.segment + 1)};
}

FourierTable::Value FourierTable::evaluate(float incident, float outgoing, float cosAzimuth) const {
    if (!(incident * outgoing < 0 ? reflects_ : transmits_)) return {};
    const SplineWeights in = nodes_.at(incident);
    const Rows rows = rowsAt(outgoing);

    // The 4 x 4 series that the splines combine. The inner 2 x 2 also contribute to the density, by their linear
    // weights.
    struct Term {
        size_t pair;
        int orders;
        float weight, linear;
        float value[3];
    };
    Term terms[16];
    int count = 0, most = 0;
    const float linearIn[4] = {0, 1 - in.t, in.t, 0}, linearOut[4] = {0, 1 - rows.at.t, rows.at.t, 0};
    for (int o = 0; o < 4; ++o)
        for (int i = 0; i < 4; ++i) {
            const float weight = rows.at.weight[size_t(o)] * in.weight[size_t(i)], linear = linearOut[o] * linearIn[i];
            if (weight == 0 && linear == 0) continue;
            const size_t p = pair(rows.at.node(o), in.node(i));
            terms[count] = {p, int(series_.orders[p]), weight, linear, {}};
            most = std::max(most, terms[count++].orders);
        }
    float cosines[kChunk];
    double current = 1, previous = cosAzimuth;  // cos(k azimuth) and cos((k - 1) azimuth)
    for (int first = 0; first < most; first += kChunk) {
        const int size = std::min(kChunk, most - first);
        for (int k = 0; k < size; ++k) {
            cosines[k] = float(current);
            const double next = 2 * double(cosAzimuth) * current - previous;
            previous = current;
            current = next;
        }
        for (Term* t = terms; t != terms + count; ++t) {
            const int orders = std::min(size, t->orders - first);
            if (orders <= 0) continue;
            for (int c = 0; c < series_.channels; ++c)
                t->value[c] += dotProduct(series(t->pair) + c * t->orders + first, cosines, orders);
        }
    }
    float channels[3] = {}, density = 0;
    for (const Term* t = terms; t != terms + count; ++t) {
        for (int c = 0; c < 3; ++c) channels[c] += t->weight * t->value[c];
        density += t->linear * std::max(0.f, t->value[0] + raise_[t->pair]);
    }
    const float sum = rows.first + rows.second;
    return {clampNonNegative(series_.channels == 1 ? Rgb(channels[0]) : toRgb(channels[0], channels[1], channels[2])),
            sum > 0 ? density / sum : 0};
}

float FourierTable::sampleIncident(int outgoing, float u, int& segment, float& t) const {
    const float* row = &cumulative_[pair(outgoing, 0)];
    const float target = u * row[nodes_.size() - 1];
    const int above = int(std::upper_bound(row, row + nodes_.size(), target) - row);
    segment = std::clamp(above - 1, 0, nodes_.size() - 2);
    // A density that is linear from a to b has the integral t (a + t (b - a) / 2) over the first fraction t of the
    // segment, which is solved for t.
    const float a = sampledMean(pair(outgoing, segment)), b = sampledMean(pair(outgoing, segment + 1));
    const float width = nodes_[segment + 1] - nodes_[segment];
    const float x = width > 0 ? (target - row[segment]) / width : 0;
    const float divisor = a + safeSqrt(a * a + 2 * (b - a) * x);
    t = divisor > 0 ? std::clamp(2 * x / divisor, 0.f, 1.f) : 0;
    return nodes_[segment] + t * width;
}

float FourierTable::sampleAzimuth(size_t p, float u) const {
    // The density is even; its integral from 0 is inverted by Newton's method, kept within a bracket.
    const bool mirrored = u < 0.5f;
    const double target = std::numbers::pi * sampledMean(p) * (mirrored ? 1 - 2 * double(u) : 2 * double(u) - 1);
    const uint32_t orders = series_.orders[p];
    const float* a = orders > 0 ? series(p) : nullptr;
    constexpr int kMostSteps = 32;
    constexpr double kPrecision = 1e-7;
    double low = 0, high = std::numbers::pi, azimuth = target / sampledMean(p);
    for (int step = 0; orders > 1 && step < kMostSteps; ++step) {
        const double cosine = std::cos(azimuth);
        double sinK = std::sin(azimuth), sinBefore = 0, cosK = cosine, cosBefore = 1;
        double integral = sampledMean(p) * azimuth, density = sampledMean(p);
        for (uint32_t k = 1; k < orders; ++k) {
            integral += a[k] * sinK / k;
            density += a[k] * cosK;
            const double nextSin = 2 * cosine * sinK - sinBefore, nextCos = 2 * cosine * cosK - cosBefore;
            sinBefore = sinK;
            sinK = nextSin;
            cosBefore = cosK;
            cosK = nextCos;
        }
        (integral < target ? low : high) = azimuth;
        double next = azimuth - (integral - target) / density;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double change = std::abs(next - azimuth);
        azimuth = next;
        if (change < kPrecision) break;
    }
    return float(mirrored ? -azimuth : azimuth);
}

std::optional<FourierTable::Direction> FourierTable::sample(float outgoing, float u0, const Vec2& u) const {
    const Rows rows = rowsAt(outgoing);
    const float sum = rows.first + rows.second;
    if (!(sum > 0)) return std::nullopt;
    // Choose a row, then an incident cosine in proportion to the interpolated means of the row, then the series of one
    // of the two nodes around this cosine. The last choice uses the rest of u0, which is uniform again.
    const float pFirst = rows.first / sum;
    const bool first = u0 < pFirst;
    const float rest = first ? u0 / pFirst : (u0 - pFirst) / (1 - pFirst);
    const int o = rows.at.segment + (first ? 0 : 1);
    int segment;
    float t;
    const float incident = sampleIncident(o, u.x, segment, t);
    const float left = (1 - t) * sampledMean(pair(o, segment)), right = t * sampledMean(pair(o, segment + 1));
    if (!(left + right > 0)) return std::nullopt;
    return Direction{incident, sampleAzimuth(pair(o, segment + (rest * (left + right) < left ? 0 : 1)), u.y)};
}

Rgb FourierTable::albedo(float outgoing) const {
    const SplineWeights at = nodes_.at(outgoing);
    Rgb sum(0.f);
    for (int i = 0; i < 4; ++i)
        if (at.weight[size_t(i)] != 0) sum += albedo_[size_t(at.node(i))] * at.weight[size_t(i)];
    return clampNonNegative(sum);
}

}  // namespace drc
