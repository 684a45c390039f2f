#include "scene/lobes/measured_table.h"

#include "base/parallel.h"
#include "scene/lobes/equivalent_alpha.h"
#include "scene/lobes/local_directions.h"

namespace drc {
namespace {

float sinTheta(const Vec3& w) { return std::sqrt(w.x * w.x + w.y * w.y); }
// Unlike acos, atan2 is exact near the normal, where the square is stretched most.
float thetaOf(const Vec3& w) { return std::atan2(sinTheta(w), w.z); }
float phiOf(const Vec3& w) { return std::atan2(w.y, w.x); }
Vec2 toSquare(float theta, float phi) {
    const float y = phi / (2 * kPi) + 0.5f;
    return Vec2(std::sqrt(theta * (2 / kPi)), y - std::floor(y));
}

int symmetriesOf(const std::vector<float>& phi) {
    if (phi.size() <= 2) return 1;
    const int turns = int(std::lround(2 * kPi / (phi.back() - phi.front())));
    return turns >= 4 ? 4 : turns >= 2 ? 2 : 1;
}

}  // namespace

MeasuredTable::MeasuredTable(MeasuredData data)
    : family_(data.phi, data.theta),
      isotropic_(data.phi.size() <= 2),
      jacobian_(data.jacobian),
      symmetries_(symmetriesOf(data.phi)),
      ndf_(data.ndfGrid, std::move(data.ndf)),
      sigma_(data.sigmaGrid, std::move(data.sigma)),
      vndf_(data.vndfGrid, std::move(data.vndf), family_.size()),
      light_(data.lightGrid, std::move(data.luminance), family_.size()),
      colors_(data.lightGrid, std::move(data.colors)) {
    integrate();
}

MeasuredTable::Turn MeasuredTable::turnFor(const Vec3& wo) const {
    if (symmetries_ == 1) return {};
    // Half a turn about the normal; with four symmetries, also the reflections in both axes.
    constexpr Turn kTurns[] = {{1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
    Turn best;
    float nearest = kInfinity;
    for (int i = 0; i < symmetries_; ++i) {
        const float phi = phiOf(kTurns[i](wo));
        const float outside = std::max({0.f, family_.first().front() - phi, phi - family_.first().back()});
        if (outside < nearest) {
            nearest = outside;
            best = kTurns[i];
        }
    }
    return best;
}

MeasuredTable::Viewed MeasuredTable::viewed(const Vec3& wo) const {
    const float theta = thetaOf(wo), phi = phiOf(wo);
    return {wo, phi, toSquare(theta, phi), family_.at(phi, theta)};
}

float MeasuredTable::stretch(const Vec2& square, float sine, float cosNormal) {
    constexpr float kLeast = 1e-6f;  // at the pole, where the mapping is singular
    return 4 * cosNormal * std::max(2 * kPi * kPi * square.x * sine, kLeast);
}

LobeValue MeasuredTable::evaluate(const Vec3& wo, const Vec3& wi) const {
    const Turn turn = turnFor(wo);
    return evaluate(viewed(turn(wo)), turn(wi));
}

LobeValue MeasuredTable::evaluate(const Viewed& from, const Vec3& wi) const {
    const Vec3 sum = from.wo + wi;
    if (!(from.wo.z > 0 && wi.z > 0)) return {};
    const Vec3 wm = normalize(sum);
    const Vec2 normal = toSquare(thetaOf(wm), phiOf(wm) - (isotropic_ ? from.phi : 0));
    const SquareWarp::Warped visible = vndf_.invert(normal, from.family);
    const SquareWarp::Warped chosen = light_.invert(visible.p, from.family);
    float scale = 1 / wi.z;
    if (jacobian_) {
        const float area = sigma_.eval(from.square);
        scale *= area > 0 ? ndf_.eval(normal) / (4 * area) : 0;
    }
    return {colors_.eval(visible.p, from.family) * scale,
            visible.pdf * chosen.pdf / stretch(normal, sinTheta(wm), dot(from.wo, wm))};
}

std::optional<Vec3> MeasuredTable::sample(const Vec3& wo, const Vec2& u) const {
    const Turn turn = turnFor(wo);  // its own inverse
    const std::optional<Vec3> wi = sample(viewed(turn(wo)), u);
    return wi ? std::optional(turn(*wi)) : std::nullopt;
}

std::optional<Vec3> MeasuredTable::sample(const Viewed& from, const Vec2& u) const {
    const SquareWarp::Warped chosen = light_.sample(u, from.family);
    const Vec2 normal = vndf_.sample(chosen.p, from.family).p;
    const float theta = sqr(normal.x) * (kPi / 2), phi = (2 * normal.y - 1) * kPi + (isotropic_ ? from.phi : 0);
    const Vec3 wm(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    if (!(dot(from.wo, wm) > 0)) return std::nullopt;
    const Vec3 wi = reflect(from.wo, wm);
    if (!(wi.z > 0)) return std::nullopt;
    return wi;
}

Rgb MeasuredTable::albedo(const Vec3& wo) const {
    const FamilyWeights family = viewed(turnFor(wo)(wo)).family;
    Rgb sum(0.f);
    for (size_t k = 0; k < 4; ++k) sum += albedo_[size_t(family.member[k])] * family.weight[k];
    return sum;
}

// Albedo and alpha, from samples at each of the measured directions.
void MeasuredTable::integrate() {
    constexpr int kSide = 32;
    constexpr float kGrazing = 0.01f, kLeastCosine = 0.1f;
    albedo_.resize(size_t(family_.size()));
    std::vector<float> alphas(albedo_.size(), kDiffuseAlpha);
    parallelFor(0, family_.size(), 1, [&](int begin, int end) {
        for (int member = begin; member < end; ++member) {
            const size_t i = size_t(member) / family_.second().size(), j = size_t(member) % family_.second().size();
            const float phi = family_.first()[i], theta = std::min(family_.second()[j], kPi / 2 - kGrazing);
            const Viewed from =
                viewed(Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
            Rgb sum(0.f);
            float largest = 0, least = kInfinity;
            for (int k = 0; k < kSide * kSide; ++k) {
                const Vec2 u((float(k % kSide) + 0.5f) / kSide, (float(k / kSide) + 0.5f) / kSide);
                const std::optional<Vec3> wi = sample(from, u);
                if (!wi) continue;
                const LobeValue value = evaluate(from, *wi);
                if (!(value.pdf > 0)) continue;
                sum += value.f * (wi->z / value.pdf);
                largest = std::max(largest, luminance(value.f) * wi->z);
                if (wi->z >= kLeastCosine) least = std::min(least, luminance(value.f));
            }
            albedo_[size_t(member)] = sum * (1.f / (kSide * kSide));
            const float energy = luminance(albedo_[size_t(member)]);
            if (energy > 0 && from.wo.z >= kLeastCosineOfAlpha)
                alphas[size_t(member)] =
                    equivalentAlpha(from.wo.z, largest / energy, std::clamp(kPi * least / energy, 0.f, 1.f));
        }
    });
    for (const float alpha : alphas) alpha_ = std::min(alpha_, alpha);
}

}  // namespace drc
