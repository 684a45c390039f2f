#include "scene/lobes/bsdf_view.h"

#include "scene/lobes/visit_lobe.h"

namespace drc {
namespace {

// Least probability of a non-specular lobe, relative to that of the likeliest lobe. The albedo is only an estimate, and
// may be zero where the lobe is not.
constexpr float kFloor = 0.05f;

bool isSpecular(LobeFlags flags) { return any(flags & LobeFlags::Specular); }

LobeValue evaluateLobe(const Lobe& lobe, const Vec3& wo, const Vec3& wi, TransportMode mode) {
    return visitLobe(
        [&](const auto& l) -> LobeValue {
            if constexpr (requires { l.evaluate(wo, wi); })
                return l.evaluate(wo, wi);
            else if constexpr (requires { l.evaluate(wo, wi, mode); })
                return l.evaluate(wo, wi, mode);
            else if constexpr (requires { l.f(wo, wi, mode); })
                return {l.f(wo, wi, mode), l.pdf(wo, wi)};
            else
                return {l.f(wo, wi), l.pdf(wo, wi)};
        },
        lobe);
}

}  // namespace

BsdfView::BsdfView(const Bsdf& bsdf, const Vec3& wo, const LobeMask& mask, TransportMode mode)
    : bsdf_(bsdf), woWorld_(wo), wo_(bsdf.frame().toLocal(wo)), woSide_(dot(wo, bsdf.ng())), mode_(mode) {
    if (wo_.z == 0) return;
    for (int i = 0; i < bsdf.size(); ++i)
        if (bsdf.isWithin(i, mask)) {
            choices_[count_++] = {i, bsdf.flags(i), 1};
            sides_ = sides_ | bsdf.flags(i);
        }
    if (count_ <= 1) return;

    float largest = 0;
    for (int k = 0; k < count_; ++k) {
        const int i = choices_[k].lobe;
        const Rgb albedo = visitLobe([&](const auto& l) { return l.albedo(wo_); }, bsdf.lobe(i));
        choices_[k].probability = std::max(0.f, luminance(bsdf.weight(i) * albedo));
        largest = std::max(largest, choices_[k].probability);
    }
    const float floor = largest > 0 ? kFloor * largest : 1;
    float sum = 0;
    for (int k = 0; k < count_; ++k) {
        Choice& c = choices_[k];
        if (!isSpecular(c.flags)) c.probability = std::max(c.probability, floor);
        sum += c.probability;
    }
    if (!(sum > 0)) count_ = 0;
    for (int k = 0; k < count_; ++k) choices_[k].probability /= sum;
}

bool BsdfView::hasNonSpecular() const {
    return std::any_of(choices_, choices_ + count_, [](const Choice& choice) { return !isSpecular(choice.flags); });
}

// The side is that of the geometric normal, so that shading normals leak no light.
LobeFlags BsdfView::sideOf(const Vec3& wi) const {
    return dot(wi, bsdf_.ng()) * woSide_ > 0 ? LobeFlags::Reflection : LobeFlags::Transmission;
}

// A lobe that both reflects and transmits chooses between the two by the side of wi in the shading frame. Where the
// geometric normal puts wi on the other side, the lobe has evaluated the wrong one, and does not contribute.
bool BsdfView::scatters(const Choice& choice, const Vec3& wi, LobeFlags side) const {
    constexpr LobeFlags kBoth = LobeFlags::Reflection | LobeFlags::Transmission;
    if ((choice.flags & kBoth) != kBoth || !bsdf_.hasSides(choice.lobe)) return any(choice.flags & side);
    return (wo_.z * wi.z > 0) == (side == LobeFlags::Reflection);
}

LobeValue BsdfView::allBut(const Choice* one, const Vec3& wi, LobeFlags side) const {
    LobeValue sum;
    for (const Choice* c = choices_; c != choices_ + count_; ++c) {
        if (c == one || isSpecular(c->flags)) continue;
        const LobeValue value = evaluateLobe(bsdf_.lobe(c->lobe), wo_, wi, mode_);
        if (scatters(*c, wi, side)) sum.f += bsdf_.weight(c->lobe) * value.f;
        sum.pdf += c->probability * value.pdf;
    }
    return sum;
}

LobeValue BsdfView::evaluate(const Vec3& wi) const {
    const LobeFlags side = sideOf(wi);
    if (!any(sides_ & side)) return {};
    return allBut(nullptr, bsdf_.frame().toLocal(wi), side);
}

std::optional<BsdfSample> BsdfView::sample(float uLobe, const Vec2& u) const {
    // After the choice of a lobe, the rest of uLobe is uniform again, for lobes that choose within themselves. If
    // rounding carries uLobe past the last lobe, the last one is chosen.
    const Choice* chosen = nullptr;
    float below = 0;
    for (const Choice* c = choices_; c != choices_ + count_; ++c) {
        if (c->probability == 0) continue;
        if (chosen) {
            if (uLobe < below + chosen->probability) break;
            below += chosen->probability;
        }
        chosen = c;
    }
    if (chosen == nullptr) return std::nullopt;
    const float uRest = std::clamp((uLobe - below) / chosen->probability, 0.f, kOneMinusEpsilon);

    const LobeSample s =
        visitLobe([&](const auto& l) { return l.sample(wo_, uRest, u, mode_); }, bsdf_.lobe(chosen->lobe));
    if (!(s.pdf > 0)) return std::nullopt;
    BsdfSample result;
    result.wi = bsdf_.frame().toWorld(s.wi);
    result.flags = s.flags;
    result.eta = s.eta;
    result.f = bsdf_.weight(chosen->lobe) * s.f;
    result.pdf = chosen->probability * s.pdf;
    if (!isSpecular(s.flags)) {
        const LobeFlags side = sideOf(result.wi);
        if (!scatters(*chosen, s.wi, side)) result.f = Rgb(0.f);
        if (count_ > 1) {
            const LobeValue others = allBut(chosen, s.wi, side);
            result.f += others.f;
            result.pdf += others.pdf;
        }
    }
    if (isBlack(result.f) || !(result.pdf > 0)) return std::nullopt;
    return result;
}

}  // namespace drc
