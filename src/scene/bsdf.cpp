#include "scene/bsdf.h"

#include "scene/bsdf_view.h"
#include "scene/visit_lobe.h"

namespace drc {

Bsdf::Bsdf(const Bsdf& other) { *this = other; }

Bsdf& Bsdf::operator=(const Bsdf& other) {
    if (this == &other) return *this;
    frame_ = other.frame_;
    ng_ = other.ng_;
    copyLobes(other);
    return *this;
}

void Bsdf::copyLobes(const Bsdf& other) {
    count_ = other.count_;
    for (int i = 0; i < count_; ++i) {
        new (storage_ + i * sizeof(Lobe)) Lobe(other.lobe(i));
        flags_[i] = other.flags_[i];
        weights_[i] = other.weights_[i];
    }
}

bool Bsdf::has(LobeFlags flags) const {
    for (int i = 0; i < count_; ++i)
        if ((flags_[i] & flags) == flags) return true;
    return false;
}

bool Bsdf::hasWithin(LobeFlags mask) const {
    for (int i = 0; i < count_; ++i)
        if (matches(flags_[i], mask)) return true;
    return false;
}

bool Bsdf::hasWideTransmission() const {
    for (int i = 0; i < count_; ++i)
        if (matches(flags_[i], LobeFlags::Wide) && any(flags_[i] & LobeFlags::Transmission)) return true;
    return false;
}

Rgb Bsdf::f(const Vec3& wo, const Vec3& wi, LobeFlags mask, TransportMode mode) const {
    return BsdfView(*this, wo, mask, mode).f(wi);
}

float Bsdf::pdf(const Vec3& wo, const Vec3& wi, LobeFlags mask) const {
    return BsdfView(*this, wo, mask).evaluate(wi).pdf;
}

std::optional<BsdfSample> Bsdf::sample(const Vec3& wo, float uLobe, const Vec2& u, LobeFlags mask,
                                       TransportMode mode) const {
    return BsdfView(*this, wo, mask, mode).sample(uLobe, u);
}

Rgb Bsdf::albedo(const Vec3& woWorld, LobeFlags mask) const {
    const Vec3 wo = frame_.toLocal(woWorld);
    Rgb sum(0.f);
    for (int i = 0; i < count_; ++i)
        if (matches(flags_[i], mask))
            sum += weights_[i] * visitLobe([&](const auto& l) { return l.albedo(wo); }, lobe(i));
    return sum;
}

}  // namespace drc
