#include "scene/bsdf.h"

#include <new>

namespace drc {
namespace {

// A lobe that is not specular is chosen with at least this part of the probability of the likeliest one: its albedo is
// only an estimate, and may be zero where the lobe is not.
constexpr float kFloor = 0.05f;

bool isSpecular(LobeFlags flags) { return any(flags & LobeFlags::Specular); }

Rgb evaluateLobe(const Lobe& lobe, const Vec3& wo, const Vec3& wi, TransportMode mode) {
    return std::visit(
        [&](const auto& l) {
            if constexpr (requires { l.f(wo, wi, mode); })
                return l.f(wo, wi, mode);
            else
                return l.f(wo, wi);
        },
        lobe);
}

}  // namespace

Bsdf::Bsdf(const Bsdf& other) { *this = other; }

Bsdf& Bsdf::operator=(const Bsdf& other) {
    if (this == &other) return *this;
    frame_ = other.frame_;
    ng_ = other.ng_;
    count_ = 0;
    for (int i = 0; i < other.count_; ++i) add(other.lobe(i), other.weights_[i]);
    return *this;
}

void Bsdf::add(const Lobe& lobe, const Rgb& weight) {
    if (count_ == kMaxLobes || isBlack(weight)) return;
    new (storage_ + count_ * sizeof(Lobe)) Lobe(lobe);
    flags_[count_] = std::visit([](const auto& l) { return l.flags(); }, lobe);
    weights_[count_] = weight;
    ++count_;
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

int Bsdf::choices(const Vec3& wo, LobeFlags mask, Probabilities& p) const {
    int matching = 0, last = 0;
    for (int i = 0; i < count_; ++i) {
        p[i] = 0;
        if (!matches(flags_[i], mask)) continue;
        ++matching;
        last = i;
    }
    if (matching <= 1) {
        if (matching == 1) p[last] = 1;
        return matching;
    }
    float largest = 0;
    for (int i = 0; i < count_; ++i) {
        if (!matches(flags_[i], mask)) continue;
        const Rgb albedo = std::visit([&](const auto& l) { return l.albedo(wo); }, lobe(i));
        p[i] = std::max(0.f, luminance(weights_[i] * albedo));
        largest = std::max(largest, p[i]);
    }
    const float floor = largest > 0 ? kFloor * largest : 1;
    float sum = 0;
    for (int i = 0; i < count_; ++i) {
        if (!matches(flags_[i], mask)) continue;
        if (!isSpecular(flags_[i])) p[i] = std::max(p[i], floor);
        sum += p[i];
    }
    if (!(sum > 0)) return 0;
    for (int i = 0; i < count_; ++i) p[i] /= sum;
    return matching;
}

Rgb Bsdf::fLocal(const Vec3& wo, const Vec3& wi, bool reflects, LobeFlags mask, TransportMode mode) const {
    const LobeFlags side = reflects ? LobeFlags::Reflection : LobeFlags::Transmission;
    Rgb sum(0.f);
    for (int i = 0; i < count_; ++i)
        if (!isSpecular(flags_[i]) && matches(flags_[i], mask) && any(flags_[i] & side))
            sum += weights_[i] * evaluateLobe(lobe(i), wo, wi, mode);
    return sum;
}

float Bsdf::pdfLocal(const Vec3& wo, const Vec3& wi, LobeFlags mask, const Probabilities& p) const {
    float sum = 0;
    for (int i = 0; i < count_; ++i)
        if (!isSpecular(flags_[i]) && matches(flags_[i], mask))
            sum += p[i] * std::visit([&](const auto& l) { return l.pdf(wo, wi); }, lobe(i));
    return sum;
}

Rgb Bsdf::f(const Vec3& woWorld, const Vec3& wiWorld, LobeFlags mask, TransportMode mode) const {
    const Vec3 wo = frame_.toLocal(woWorld);
    if (wo.z == 0) return Rgb(0.f);
    const bool reflects = dot(wiWorld, ng_) * dot(woWorld, ng_) > 0;
    return fLocal(wo, frame_.toLocal(wiWorld), reflects, mask, mode);
}

Bsdf::Value Bsdf::evaluate(const Vec3& woWorld, const Vec3& wiWorld, LobeFlags mask, TransportMode mode) const {
    Value value;
    const Vec3 wo = frame_.toLocal(woWorld), wi = frame_.toLocal(wiWorld);
    if (wo.z == 0) return value;
    const bool reflects = dot(wiWorld, ng_) * dot(woWorld, ng_) > 0;
    value.f = fLocal(wo, wi, reflects, mask, mode);
    if (isBlack(value.f)) return value;
    Probabilities p;
    if (choices(wo, mask, p) > 0) value.pdf = pdfLocal(wo, wi, mask, p);
    return value;
}

float Bsdf::pdf(const Vec3& woWorld, const Vec3& wiWorld, LobeFlags mask) const {
    const Vec3 wo = frame_.toLocal(woWorld);
    if (wo.z == 0) return 0;
    Probabilities p;
    if (choices(wo, mask, p) == 0) return 0;
    return pdfLocal(wo, frame_.toLocal(wiWorld), mask, p);
}

std::optional<BsdfSample> Bsdf::sample(const Vec3& woWorld, float uLobe, const Vec2& u, LobeFlags mask,
                                       TransportMode mode) const {
    const Vec3 wo = frame_.toLocal(woWorld);
    Probabilities p;
    if (wo.z == 0 || choices(wo, mask, p) == 0) return std::nullopt;

    // What is left of uLobe after the choice is uniform again, for lobes that choose within themselves. Rounding may
    // carry it past the last lobe, which is then the choice.
    int chosen = -1;
    float below = 0;
    for (int i = 0; i < count_; ++i) {
        if (p[i] == 0) continue;
        if (chosen >= 0) {
            if (uLobe < below + p[chosen]) break;
            below += p[chosen];
        }
        chosen = i;
    }
    const float uRest = std::clamp((uLobe - below) / p[chosen], 0.f, kOneMinusEpsilon);

    const LobeSample s = std::visit([&](const auto& l) { return l.sample(wo, uRest, u, mode); }, lobe(chosen));
    if (!(s.pdf > 0)) return std::nullopt;
    BsdfSample result;
    result.wi = frame_.toWorld(s.wi);
    result.flags = s.flags;
    result.eta = s.eta;
    if (isSpecular(s.flags)) {
        result.f = weights_[chosen] * s.f;
        result.pdf = p[chosen] * s.pdf;
    } else {
        const bool reflects = dot(result.wi, ng_) * dot(woWorld, ng_) > 0;
        result.f = fLocal(wo, s.wi, reflects, mask, mode);
        result.pdf = pdfLocal(wo, s.wi, mask, p);
    }
    if (isBlack(result.f) || !(result.pdf > 0)) return std::nullopt;
    return result;
}

Rgb Bsdf::albedo(const Vec3& woWorld, LobeFlags mask) const {
    const Vec3 wo = frame_.toLocal(woWorld);
    Rgb sum(0.f);
    for (int i = 0; i < count_; ++i)
        if (matches(flags_[i], mask))
            sum += weights_[i] * std::visit([&](const auto& l) { return l.albedo(wo); }, lobe(i));
    return sum;
}

}  // namespace drc
