#include "transport/direct_lighting.h"

#include "scene/media/henyey_greenstein.h"

namespace drc {

Rgb DirectLighting::emissionAtHit(const SurfaceInteraction& hit, const Vec3& from, float pdf) const {
    Rgb sum(0.f);
    forLightAt(hit, [&](const AreaLight& light, const Rgb& emitted) {
        if (pdf == kSpecular) {
            sum = emitted;
            return;
        }
        const float lightPdf = lights_.probability(from, &light) * light.pdf(from, -hit.wo, hit.emitterHit());
        sum = emitted * powerHeuristic(pdf, lightPdf);
    });
    return sum;
}

Rgb DirectLighting::emissionAtInfinity(const Ray& ray, const Vec3& from, float pdf, int group) const {
    Rgb sum(0.f);
    const Vec3& d = ray.d;
    forLightsAtInfinity(from, ray, [&](const Light& light, const Rgb& radiance) {
        float weight = 1;
        if (pdf != kSpecular) {
            float lightPdf = lights_.probability(from, &light);
            if (group != kNoGroup && &light == guide_->light()) {
                const EnvironmentWindows::Inverse at = guide_->windows().inverse(from, d);
                lightPdf *= at.pdf * guide_->density(group, at.u);
            } else {
                lightPdf *= light.pdfEscaped(from, d);
            }
            weight = powerHeuristic(pdf, lightPdf);
        }
        sum += radiance * weight;
    });
    return sum;
}

template <class Scattered>
DirectLighting::Proposal DirectLighting::propose(const Vec3& p, int group, float uLight, const Vec2& u,
                                                 Scattered&& scattered) const {
    const auto choice = lights_.sample(p, uLight);
    if (choice.light == nullptr) return {};
    float pdf = choice.probability;
    Vec2 onLight = u;
    int slot = -1;
    if (group != kNoGroup && choice.light == guide_->light()) {
        const EnvironmentGuide::Guided guided = guide_->sample(group, u);
        onLight = guided.u;
        pdf *= guided.density;
        slot = guided.slot;
    }
    const auto s = slot >= 0 ? guide_->windows().sample(p, onLight) : choice.light->sample(p, onLight);
    const bool infinite = choice.light->isInfinite();
    if (!s || !(s->pdf > 0) || (!infinite && isBlack(s->radiance))) {
        if (slot >= 0) guide_->learn(slot, false);
        return {};
    }
    const LobeValue value = scattered(s->wi);
    if (isBlack(value.f)) {
        if (slot >= 0) guide_->learn(slot, false);
        return {};
    }
    pdf *= s->pdf;
    return {choice.light, *s, value.f * (1 / pdf), pdf, value.pdf, slot};
}

DirectLighting::Proposal DirectLighting::propose(const SurfaceInteraction& at, const BsdfView& bsdf, int group,
                                                 float uLight, const Vec2& u) const {
    return propose(at.p, group, uLight, u, [&](const Vec3& wi) {
        LobeValue value = bsdf.evaluate(wi);
        value.f *= absDot(wi, bsdf.bsdf().frame().n);
        return value;
    });
}

DirectLighting::Proposal DirectLighting::propose(const MediumVertex& at, float uLight, const Vec2& u) const {
    return propose(at.p, kNoGroup, uLight, u, [&](const Vec3& wi) {
        const float phase = phaseHenyeyGreenstein(at.medium->g, at.wo, wi);
        return LobeValue{Rgb(phase), phase};
    });
}

Rgb DirectLighting::arriving(const SpawnPoint& from, const Medium* medium, float time, Proposal& proposal) const {
    const LightSample& s = proposal.sample;
    const bool blocked = shadowed(accel_, from, s.wi, s.distance, time);
    if (proposal.slot >= 0) guide_->learn(proposal.slot, !blocked);
    if (blocked) return Rgb(0.f);
    proposal.screened = accel_.hasShadowMasks() && screened(accel_, from, s.wi, s.distance, time);
    Rgb light =
        proposal.throughput * (proposal.light->isInfinite() ? proposal.light->escaped(from.p, s.wi) : s.radiance);
    if (medium || accel_.hasOpenMedia()) light *= transmittance(accel_, from, medium, s.wi, s.distance, time);
    return light;
}

}  // namespace drc
