#include "scene/bsdf.h"

#include "scene/bent_normal.h"
#include "scene/bsdf_view.h"
#include "scene/visit_lobe.h"

namespace drc {

Bsdf::Lobes& Bsdf::Lobes::operator=(const Lobes& other) {
    if (this == &other) return *this;
    count = other.count;
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
    bent_ = other.bent_;
    own_ = other.own_;
    lobes_ = other.lobes_ == &other.own_ ? &own_ : other.lobes_;
    return *this;
}

void Bsdf::bendFor(const Vec3& wo) {
    frame_ = unbent_;
    bent_ = false;
    // Whatever has its view above the horizon of the mirrored view needs nothing: the lobes are asked only for the
    // rest.
    if (!bentNormal(unbent_.n, ng_, wo, KeepAbove::MirroredView)) return;
    // Fibres do not tell reflection from transmission by a horizon.
    bool hasSides = false, mirrors = false;
    for (int i = 0; i < size(); ++i) {
        if (!this->hasSides(i)) continue;
        hasSides = true;
        mirrors |= any(flags(i) & LobeFlags::Reflection) && any(flags(i) & (LobeFlags::Glossy | LobeFlags::Specular));
    }
    if (!hasSides) return;
    const auto normal = bentNormal(unbent_.n, ng_, wo, mirrors ? KeepAbove::MirroredView : KeepAbove::View);
    if (!normal) return;
    frame_ = Frame::fromNormalAndTangent(*normal, unbent_.s);
    bent_ = true;
}

Bsdf Bsdf::seenFrom(const Vec3& wo) const {
    Bsdf seen(unbent_, ng_);
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

}  // namespace drc
