#include "scene/lobes/bsdf.h"

#include <bit>
#include <cmath>

#include "scene/lobes/bsdf_view.h"
#include "scene/lobes/visit_lobe.h"

namespace drc {
namespace {

// lobe: must be separable.
Rgb viewFactorOf(const Lobe& lobe, const Vec3& wo) {
    return visitLobe(
        [&](const auto& l) {
            if constexpr (requires { l.viewFactor(wo); })
                return l.viewFactor(wo);
            else
                return Rgb(0.f);
        },
        lobe);
}

// Whether the view factors of two separable lobes are proportional. View factors are smooth functions of the cosine
// alone, so that a comparison at a few directions is enough.
bool dependAlikeOnView(const Lobe& a, const Lobe& b) {
    constexpr float kTolerance = 1e-4f;
    const Vec3 normal(0, 0, 1);
    const Rgb aAtNormal = viewFactorOf(a, normal), bAtNormal = viewFactorOf(b, normal);
    for (const float cosine : {0.05f, 0.3f, 0.7f}) {
        const Vec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
        const Rgb aThere = viewFactorOf(a, wo) * bAtNormal, bThere = viewFactorOf(b, wo) * aAtNormal;
        for (int c = 0; c < 3; ++c)
            if (std::abs(aThere[c] - bThere[c]) > kTolerance * aAtNormal[c] * bAtNormal[c]) return false;
    }
    return true;
}

}  // namespace

Bsdf::Lobes& Bsdf::Lobes::operator=(const Lobes& other) {
    if (this == &other) return *this;
    count = other.count;
    separable = other.separable;
    for (int i = 0; i < count; ++i) {
        new (storage + i * sizeof(Lobe)) Lobe(reinterpret_cast<const Lobe*>(other.storage)[i]);
        flags[size_t(i)] = other.flags[size_t(i)];
        alphas[size_t(i)] = other.alphas[size_t(i)];
        weights[size_t(i)] = other.weights[size_t(i)];
        hasSides[size_t(i)] = other.hasSides[size_t(i)];
    }
    return *this;
}

Bsdf::Bsdf(const Bsdf& other) { *this = other; }

Bsdf& Bsdf::operator=(const Bsdf& other) {
    frame_ = other.frame_;
    unbent_ = other.unbent_;
    ng_ = other.ng_;
    own_ = other.own_;
    lobes_ = other.lobes_ == &other.own_ ? &own_ : other.lobes_;
    return *this;
}

void Bsdf::bend(const Vec3& wo) {
    // KeepAbove::MirroredView is the stricter condition. If it holds, nothing is bent, and there is no need to look at
    // the lobes.
    if (!bentNormal(frame_.n, ng_, wo, KeepAbove::MirroredView)) return;
    // Hair lobes have no horizon, see hasSides().
    bool hasSides = false, mirrors = false;
    for (int i = 0; i < size(); ++i) {
        if (!this->hasSides(i)) continue;
        hasSides = true;
        mirrors |= any(flags(i) & LobeFlags::Reflection) && any(flags(i) & (LobeFlags::Glossy | LobeFlags::Specular));
    }
    if (!hasSides) return;
    const auto normal = bentNormal(frame_.n, ng_, wo, mirrors ? KeepAbove::MirroredView : KeepAbove::View);
    if (!normal) return;
    unbent_ = frame_;
    frame_ = Frame::fromNormalAndTangent(*normal, unbent_->s);
}

Bsdf Bsdf::seenFrom(const Vec3& wo) const {
    Bsdf seen(unbent_.value_or(frame_), ng_);
    seen.borrowLobes(*this);
    seen.bendFor(wo);
    return seen;
}

bool Bsdf::has(LobeFlags wanted, const LobeMask& mask) const {
    for (int i = 0; i < size(); ++i)
        if ((flags(i) & wanted) == wanted && isWithin(i, mask)) return true;
    return false;
}

Rgb Bsdf::f(const Vec3& wo, const Vec3& wi, const LobeMask& mask, TransportMode mode) const {
    return BsdfView(*this, wo, mask, mode).f(wi);
}

float Bsdf::pdf(const Vec3& wo, const Vec3& wi, const LobeMask& mask) const {
    return BsdfView(*this, wo, mask).evaluate(wi).pdf;
}

std::optional<BsdfSample> Bsdf::sample(const Vec3& wo, float uLobe, const Vec2& u, const LobeMask& mask,
                                       TransportMode mode) const {
    return BsdfView(*this, wo, mask, mode).sample(uLobe, u);
}

Rgb Bsdf::albedo(const Vec3& woWorld, const LobeMask& mask) const {
    const Vec3 wo = frame_.toLocal(woWorld);
    Rgb sum(0.f);
    for (int i = 0; i < size(); ++i)
        if (isWithin(i, mask)) sum += weight(i) * visitLobe([&](const auto& l) { return l.albedo(wo); }, lobe(i));
    return sum;
}

Rgb Bsdf::viewFactor(const Vec3& woWorld, LobeSet lobes) const {
    const Vec3 wo = frame_.toLocal(woWorld);
    Rgb sum(0.f);
    for (int i = 0; i < size(); ++i)
        if (lobes >> i & 1) sum += weight(i) * viewFactorOf(lobe(i), wo);
    return sum;
}

LobeSet Bsdf::separableLobes() const {
    const LobeSet all = lobes_->separable;
    if (std::has_single_bit(all) || all == 0) return all;
    // The main lobe has the greatest albedo along the normal, so that all views choose the same lobes.
    const Vec3 normal(0, 0, 1);
    int main = 0;
    float greatest = -1;
    for (int i = 0; i < size(); ++i) {
        if (!(all >> i & 1)) continue;
        const Rgb albedo = visitLobe([&](const auto& l) { return l.albedo(normal); }, lobe(i));
        const float own = luminance(weight(i) * albedo);
        if (own > greatest) greatest = own, main = i;
    }
    LobeSet alike = 0;
    for (int i = 0; i < size(); ++i)
        if ((all >> i & 1) && (i == main || dependAlikeOnView(lobe(i), lobe(main)))) alike |= LobeSet(1 << i);
    return alike;
}

}  // namespace drc
