#include "integrators/path_tracer.h"

#include <utility>

namespace drc {
namespace {

// Density that stands for a direction no light sample could have produced: after a specular lobe, or from the camera.
constexpr float kSpecular = 0;
// Where it was measured, four times as many paths for narrow lobes cost 2 to 6 % of the time and took 8 to 13 % off the
// error; eight times, no more.
constexpr float kNarrowPaths = 4;

constexpr LobeFlags kSpecularLobes = LobeFlags::Specular | LobeFlags::Reflection | LobeFlags::Transmission;

float powerHeuristic(float a, float b) {
    const float a2 = a * a, b2 = b * b;
    return a2 > 0 ? a2 / (a2 + b2) : 0;
}

// Lobes only estimate their albedos.
Rgb unitAlbedo(const Bsdf& bsdf, const Vec3& wo) {
    Rgb albedo = bsdf.albedo(wo);
    for (int c = 0; c < 3; ++c) albedo[c] = albedo[c] > 0 ? std::min(albedo[c], 1.f) : 0.f;
    return albedo;
}

}  // namespace

Rgb PathTracer::emissionAtHit(const SurfaceInteraction& hit, const Vec3& from, float pdf) const {
    const AreaLight* light = hit.primitive->areaLight.get();
    if (light == nullptr) return Rgb(0.f);
    const Rgb emitted = hit.emitted();
    if (isBlack(emitted) || pdf == kSpecular) return emitted;
    const float lightPdf = lights_.probability(from, light) * light->pdf(from, -hit.wo, hit.emitterHit());
    return emitted * powerHeuristic(pdf, lightPdf);
}

Rgb PathTracer::emissionAtInfinity(const Vec3& d, const Vec3& from, float pdf, int group) const {
    Rgb sum(0.f);
    for (const Light* light : lights_.infiniteLights()) {
        const Rgb radiance = light->escaped(d);
        if (isBlack(radiance)) continue;
        float weight = 1;
        if (pdf != kSpecular) {
            float lightPdf = lights_.probability(from, light) * light->pdfEscaped(d);
            if (group != kNoGroup && light == guide_->light()) lightPdf *= guide_->density(group, light->inverse(d));
            weight = powerHeuristic(pdf, lightPdf);
        }
        sum += radiance * weight;
    }
    return sum;
}

PathTracer::LightProposal PathTracer::proposeLight(const SurfaceInteraction& at, const BsdfView& bsdf, int group,
                                                   const VertexNumbers& numbers) const {
    const auto choice = lights_.sample(at.p, numbers.light);
    if (choice.light == nullptr) return {};
    float pdf = choice.probability;
    Vec2 u = numbers.onLight;
    int slot = -1;
    if (group != kNoGroup && choice.light == guide_->light()) {
        const EnvironmentGuide::Guided guided = guide_->sample(group, u);
        u = guided.u;
        pdf *= guided.density;
        slot = guided.slot;
    }
    const auto s = choice.light->sample(at.p, u);
    const bool infinite = choice.light->isInfinite();
    if (!s || !(s->pdf > 0) || (!infinite && isBlack(s->radiance))) return {};
    const LobeValue value = bsdf.evaluate(s->wi);
    if (isBlack(value.f)) {
        if (slot >= 0) guide_->learn(slot, false);
        return {};
    }
    pdf *= s->pdf;
    const float weight = s->delta ? 1 : powerHeuristic(pdf, value.pdf);
    return {choice.light, *s, value.f * (absDot(s->wi, bsdf.bsdf().frame().n) * weight / pdf), slot};
}

Rgb PathTracer::arriving(const SurfaceInteraction& at, const LightProposal& proposal) const {
    if (proposal.light == nullptr) return Rgb(0.f);
    const bool blocked = shadowed(accel_, at.spawnPoint(), proposal.sample.wi, proposal.sample.distance, at.time);
    if (proposal.slot >= 0) guide_->learn(proposal.slot, !blocked);
    if (blocked) return Rgb(0.f);
    const LightSample& s = proposal.sample;
    return proposal.weight * (proposal.light->isInfinite() ? proposal.light->escaped(s.wi) : s.radiance);
}

bool PathTracer::scatter(Path& path, const SurfaceInteraction& hit, const BsdfView& bsdf,
                         const VertexNumbers& u) const {
    const auto s = bsdf.sample(u.lobe, u.direction);
    if (!s || !(s->pdf > 0)) return false;
    path.throughput *= s->f * (absDot(s->wi, bsdf.bsdf().frame().n) / s->pdf);
    if (isBlack(path.throughput)) return false;
    path.etaScale *= sqr(s->eta);
    if (s->isSpecular()) {
        path.pdf = kSpecular;
        if (++path.chain > kMaxSpecularChain) return false;
    } else {
        path.pdf = s->pdf;
        ++path.depth;
    }
    path.from = hit.p;
    path.ray = hit.spawnRay(s->wi, spreadAfter(*s, hit.coneSpread));

    if (path.depth + path.chain >= settings_.rouletteDepth) {
        const float survival = std::min(0.95f, maxComponent(path.throughput) * path.etaScale);
        if (u.roulette >= survival) return false;
        path.throughput *= 1 / survival;
    }
    return true;
}

Rgb PathTracer::trace(const Ray& firstRay, Sampler& sampler, Emission emission, FirstHit* first,
                      const SurfaceInteraction* start) const {
    Rgb sum(0.f);
    Path path{firstRay, firstRay.o};
    bool counted = emission == Emission::Counted;
    // What is left out is direct light: the vertex that the ray leaves was the path's first.
    const int maxDepth = settings_.maxDepth - (counted ? 0 : 1);
    // Where to record what comes next: each until it is known.
    FirstHit *hitWanted = first, *albedoWanted = nullptr, *directWanted = first;
    SurfaceInteraction hit;
    Accel::Found found;
    bool met = start == nullptr && accel_.find(path.ray, found);
    for (;;) {
        if (start) {
            hit = *start;
            start = nullptr;
        } else if (!met || !nextSurface(accel_, path.ray, found, hit)) {
            if (counted) sum += path.throughput * emissionAtInfinity(path.ray.d, path.from, path.pdf, path.group);
            break;
        }
        if (hitWanted) {
            hitWanted->distance = length(hit.p - path.from);
            hitWanted->normal = faceForward(hit.ng, hit.wo);
            albedoWanted = std::exchange(hitWanted, nullptr);
        }
        if (counted) sum += path.throughput * emissionAtHit(hit, path.from, path.pdf);
        if (!hit.primitive->material) {  // an emitter without a body
            path.ray = hit.spawnRay(path.ray.d);
            if (++path.chain > kMaxPassThrough) break;
            met = accel_.find(path.ray, found);
            continue;
        }
        counted = true;
        if (path.depth >= maxDepth) break;

        const Bsdf bsdf = hit.bsdf();
        if (bsdf.size() == 0) break;
        path.group = groupOf(hit, bsdf);
        if (albedoWanted) std::exchange(albedoWanted, nullptr)->albedo = unitAlbedo(bsdf, hit.wo);
        const BsdfView view(bsdf, hit.wo);
        const VertexNumbers u(sampler);
        LightProposal light;
        if (bsdf.hasNonSpecular()) light = proposeLight(hit, view, path.group, u);
        const Rgb throughput = path.throughput;
        const int depth = path.depth;
        const bool goesOn = scatter(path, hit, view, u);
        // The path's own ray before the shadow ray, which then hides the wait for the data of the surface met.
        met = goesOn && accel_.find(path.ray, found);
        if (directWanted && depth > 0) std::exchange(directWanted, nullptr)->direct = sum;
        sum += throughput * arriving(hit, light);
        if (!goesOn) break;
    }
    if (directWanted) directWanted->direct = sum;
    if (!isFinite(sum)) {
        if (first) first->direct = Rgb(0.f);
        return Rgb(0.f);
    }
    const float l = luminance(sum);
    if (l <= settings_.clamp) return sum;
    if (first) first->direct *= settings_.clamp / l;
    return sum * (settings_.clamp / l);
}

Rgb PathTracer::radiance(const Ray& ray, Sampler& sampler) const {
    return trace(ray, sampler, Emission::Counted, nullptr);
}

Rgb PathTracer::incident(const Ray& ray, Sampler& sampler, FirstHit* first) const {
    return trace(ray, sampler, Emission::SkippedAtFirst, first);
}

Rgb PathTracer::bsdfSample(const SurfaceInteraction& at, const BsdfView& view, int group, const Rgb& throughput,
                           const VertexNumbers& u, Sampler& sampler, SampleLayers* layers) const {
    Rgb sum(0.f);
    const Bsdf& bsdf = view.bsdf();
    const auto s = view.sample(u.lobe, u.direction);
    if (!s) return sum;
    const Rgb scale = throughput * (absDot(s->wi, bsdf.frame().n) / s->pdf);
    Ray next = at.spawnRay(s->wi, spreadAfter(*s, at.coneSpread));
    SurfaceInteraction hit;
    // Emitters without a body do not end the search for the environment or for others behind them.
    for (int i = 0; i < kMaxPassThrough; ++i) {
        if (!nextSurface(accel_, next, hit)) return sum + scale * s->f * emissionAtInfinity(s->wi, at.p, s->pdf, group);
        sum += scale * s->f * emissionAtHit(hit, at.p, s->pdf);
        if (hit.primitive->material) break;
        next = hit.spawnRay(s->wi);
    }
    if (layers && layers->traceWide) {
        const Rgb wide = bsdf.hasWithin(glossy()) ? bsdf.f(at.wo, s->wi, broad()) : s->f;
        if (!isBlack(wide))
            layers->wide += scale * wide * trace(next, sampler, Emission::SkippedAtFirst, nullptr, &hit);
    }
    return sum;
}

Rgb PathTracer::direct(const Ray& cameraRay, Sampler& sampler, SampleLayers* layers) const {
    Ray ray = cameraRay;
    Rgb sum(0.f), throughput(1.f);
    SurfaceInteraction hit;
    for (int chain = 0; chain <= kMaxSpecularChain; ++chain) {
        if (!nextSurface(accel_, ray, hit)) {
            sum += throughput * emissionAtInfinity(ray.d, ray.o, kSpecular, kNoGroup);
            break;
        }
        sum += throughput * emissionAtHit(hit, ray.o, kSpecular);
        if (!hit.primitive->material) {
            ray = hit.spawnRay(ray.d);
            continue;
        }
        const Bsdf bsdf = hit.bsdf();
        if (bsdf.hasNonSpecular()) {
            const int group = groupOf(hit, bsdf);
            const BsdfView view(bsdf, hit.wo, LobeFlags::NonSpecular);
            const VertexNumbers u(sampler);
            const Rgb arrived = throughput * arriving(hit, proposeLight(hit, view, group, u));
            const Rgb lit = arrived + bsdfSample(hit, view, group, throughput, u, sampler, layers);
            sum += lit;
            if (layers) layers->lit += lit;
        }
        if (layers) {
            if (bsdf.hasWithin(glossy())) {
                layers->narrow += throughput * indirectNarrow(hit, bsdf, sampler);
                if (isBlack(layers->narrowAlbedo)) layers->narrowAlbedo = throughput * bsdf.albedo(hit.wo, glossy());
            }
            if (isBlack(layers->wideAlbedo) && bsdf.hasWithin(broad()))
                layers->wideAlbedo = throughput * bsdf.albedo(hit.wo, broad());
            if (layers->pixelSize == 0 && bsdf.hasNonSpecular()) {
                layers->albedo = throughput * bsdf.albedo(hit.wo, LobeFlags::NonSpecular);
                layers->position = hit.p;
                layers->normal = bsdf.frame().n;
                layers->pixelSize = hit.footprint;
            }
        }
        if (!bsdf.hasSpecular()) break;
        const float uLobe = sampler.get1D();
        const auto s = bsdf.sample(hit.wo, uLobe, sampler.get2D(), kSpecularLobes);
        if (!s || !(s->pdf > 0)) break;
        throughput *= s->f * (absDot(s->wi, bsdf.frame().n) / s->pdf);
        if (isBlack(throughput)) break;
        ray = hit.spawnRay(s->wi);
    }
    if (layers)
        for (Rgb* light : {&layers->lit, &layers->narrow, &layers->wide})
            if (!isFinite(*light)) *light = Rgb(0.f);
    return isFinite(sum) ? sum : Rgb(0.f);
}

bool PathTracer::primaryHit(const Ray& cameraRay, Sampler& sampler, PrimaryHit& result) const {
    Ray ray = cameraRay;
    result.throughput = Rgb(1.f);
    result.distance = 0;
    result.bounces = 0;
    for (int chain = 0; chain <= kMaxSpecularChain; ++chain) {
        if (!nextSurface(accel_, ray, result.surface)) return false;
        result.distance += result.surface.t;
        if (!result.surface.primitive->material) {
            ray = result.surface.spawnRay(ray.d);
            continue;
        }
        const SurfaceInteraction& at = result.surface;
        result.bsdf = at.bsdf();
        const bool specular = result.bsdf.hasSpecular(), other = result.bsdf.hasNonSpecular();
        if (!specular && !other) return false;
        float probability = other ? 1.f : 0.f;  // of stopping here
        if (specular && other) {
            const float a = luminance(result.bsdf.albedo(at.wo, LobeFlags::NonSpecular));
            const float b = luminance(result.bsdf.albedo(at.wo, kSpecularLobes));
            probability = std::clamp(a / std::max(a + b, 1e-8f), 0.1f, 0.9f);
        }
        const float uLobe = sampler.get1D(), uStop = sampler.get1D();
        const Vec2 u = sampler.get2D();
        if (uStop < probability) {
            result.throughput *= 1 / probability;
            return true;
        }
        const auto s = result.bsdf.sample(at.wo, uLobe, u, kSpecularLobes);
        if (!s || !(s->pdf > 0)) return false;
        result.throughput *= s->f * (absDot(s->wi, result.bsdf.frame().n) / (s->pdf * (1 - probability)));
        if (isBlack(result.throughput)) return false;
        ray = at.spawnRay(s->wi);
        ++result.bounces;
    }
    return false;
}

Rgb PathTracer::indirect(const PrimaryHit& hit, Sampler& sampler, const LobeMask& lobes) const {
    const float uLobe = sampler.get1D();
    const auto s = hit.bsdf.sample(hit.surface.wo, uLobe, sampler.get2D(), lobes);
    if (!s || !(s->pdf > 0) || isBlack(s->f)) return Rgb(0.f);
    const Ray ray = hit.surface.spawnRay(s->wi, spreadAfter(*s, hit.surface.coneSpread));
    return s->f * incident(ray, sampler) * (absDot(s->wi, hit.bsdf.frame().n) / s->pdf);
}

Rgb PathTracer::indirectNarrow(const SurfaceInteraction& at, const Bsdf& bsdf, Sampler& sampler) const {
    const float uLobe = sampler.get1D();
    const auto s = bsdf.sample(at.wo, uLobe, sampler.get2D(), glossy());
    if (!s) return Rgb(0.f);
    const Rgb weight = s->f * (absDot(s->wi, bsdf.frame().n) / s->pdf);
    // A dim reflection on a dark surface is most of what is seen of it, and nothing smooths its noise: traced several
    // times as often as the path tracer would choose these lobes among all.
    const float narrow = luminance(bsdf.albedo(at.wo, glossy()));
    const float all = luminance(bsdf.albedo(at.wo, LobeFlags::NonSpecular));
    const float survival = std::min(1.f, std::max(maxComponent(weight), kNarrowPaths * narrow / std::max(all, 1e-6f)));
    if (!(sampler.get1D() < survival)) return Rgb(0.f);
    const Ray ray = at.spawnRay(s->wi, spreadAfter(*s, at.coneSpread));
    return weight * incident(ray, sampler) * (1 / survival);
}

}  // namespace drc
