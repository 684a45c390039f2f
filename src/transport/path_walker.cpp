#include "transport/path_walker.h"

#include <utility>

#include "scene/media/henyey_greenstein.h"

namespace drc {
namespace {

// Clamped to [0, 1], because lobes only estimate their albedos.
Rgb unitAlbedo(const Bsdf& bsdf, const Vec3& wo) {
    Rgb albedo = bsdf.albedo(wo);
    for (int c = 0; c < 3; ++c) albedo[c] = albedo[c] > 0 ? std::min(albedo[c], 1.f) : 0.f;
    return albedo;
}

}  // namespace

bool SpecularChain::follow(const Bsdf& bsdf, float uLobe, const Vec2& u, float probability) {
    if (bounces_ >= kMaxSpecularChain) return false;
    const auto s = bsdf.sample(surface_.wo, uLobe, u, kSpecularLobes);
    if (!s || !(s->pdf > 0)) return false;
    throughput_ *= s->f * (absDot(s->wi, bsdf.frame().n) / (s->pdf * probability));
    if (isBlack(throughput_)) return false;
    from_ = surface_.p;
    ray_ = surface_.mirroredRay(s->wi);
    ++bounces_;
    return true;
}

bool PathWalker::scatter(PathState& path, const SurfaceInteraction& hit, const BsdfView& view,
                         const VertexNumbers& u) const {
    const auto s = view.sample(u.lobe, u.direction);
    if (!s || !(s->pdf > 0)) return false;
    path.weight = s->f * (absDot(s->wi, view.bsdf().frame().n) / s->pdf);
    path.throughput *= path.weight;
    if (isBlack(path.throughput)) return false;
    path.etaScale *= sqr(s->eta);
    if (s->isSpecular()) {
        path.pdf = DirectLighting::kSpecular;
        if (++path.chain > kMaxSpecularChain) return false;
    } else {
        path.pdf = s->pdf;
        ++path.depth;
    }
    path.from = hit.p;
    path.ray = s->isSpecular() ? hit.mirroredRay(s->wi) : hit.spawnRay(s->wi, spreadAfter(*s, hit.coneSpread));
    return survives(path, u.roulette);
}

bool PathWalker::scatter(PathState& path, const MediumVertex& at, const VertexNumbers& u) const {
    const Vec3 wi = sampleHenyeyGreenstein(at.medium->g, at.wo, u.direction);
    path.weight = Rgb(1.f);
    path.pdf = phaseHenyeyGreenstein(at.medium->g, at.wo, wi);
    path.group = DirectLighting::kNoGroup;
    ++path.depth;
    path.from = at.p;
    path.ray = at.spawnRay(wi, std::max(at.coneSpread, kDiffuseSpread));
    return survives(path, u.roulette);
}

bool PathWalker::survives(PathState& path, float u) const {
    if (path.depth + path.chain < settings_.rouletteDepth) return true;
    const float survival = std::min(0.95f, maxComponent(path.throughput) * path.etaScale);
    if (u >= survival) return false;
    path.throughput *= 1 / survival;
    path.weight *= 1 / survival;
    return true;
}

void PathWalker::recordThroughMedia(Ray ray, Rgb seen, float distance, GBufferSample& gBuffer) const {
    const Accel& accel = lighting_.accel();
    SurfaceInteraction hit;
    Accel::Found found;
    const bool any = accel.find(ray, found);
    const auto goesOn = [&](const Ray& segment, float length) {
        if (segment.medium) {
            const float reach = accel.lengthInMedium(length);
            gBuffer.albedo += seen * segment.medium->scatteredIn(reach);
            seen *= segment.medium->transmittance(reach);
        }
        distance += length;
        return true;
    };
    const Arrival arrival = toSurface(
        accel, ray, found, any, hit, [](const SurfaceInteraction&) {}, goesOn);
    if (arrival == Arrival::Surface) gBuffer.record(seen, hit, hit.bsdf(), distance);
}

Rgb PathWalker::walk(const Ray& firstRay, Sampler& sampler, FirstEmission emission, PathSinks sinks,
                     const SurfaceInteraction* start) const {
    Rgb sum(0.f);
    PathState path(firstRay);
    bool counted = emission == FirstEmission::Counted;
    // If first emission is skipped, the ray's origin was the path's first vertex.
    const int maxDepth = settings_.maxDepth - (counted ? 0 : 1);
    // Where to record the next values; each is reset once it is known.
    FirstHit *hitWanted = sinks.firstHit, *albedoWanted = nullptr;
    Rgb* const direct = sinks.firstHit ? &sinks.firstHit->direct : sinks.direct;
    Rgb* directWanted = direct;
    const Accel& accel = lighting_.accel();
    SurfaceInteraction hit;
    MediumVertex inMedium;
    Accel::Found found;
    bool any = start == nullptr && accel.find(path.ray, found);
    for (;;) {
        const auto met = [&](const SurfaceInteraction& surface) {
            path.distance += surface.t;
            if (hitWanted) {
                hitWanted->distance = length(surface.p - path.from);
                hitWanted->normal = faceForward(surface.ng, surface.wo);
                albedoWanted = std::exchange(hitWanted, nullptr);
            }
            if (counted) sum += path.throughput * lighting_.emissionAtHit(surface, path.from, path.pdf);
        };
        if (start) {
            hit = *std::exchange(start, nullptr);
            met(hit);
        } else {
            const auto passed = [&](const Rgb& emitted, const Rgb&) {
                if (counted) sum += path.throughput * emitted;
            };
            const Arrival arrival = advance(path, any, found, hit, inMedium, sampler, sinks.gBuffer, met, passed);
            if (arrival == Arrival::Escaped && counted)
                sum += path.throughput * lighting_.emissionAtInfinity(path.ray, path.from, path.pdf, path.group);
            if (arrival == Arrival::Scattered) {
                counted = true;
                if (path.depth >= maxDepth) break;
                if (directWanted && path.depth > 0) *std::exchange(directWanted, nullptr) = sum;
                const VertexNumbers u(sampler);
                DirectLighting::Proposal light = lighting_.propose(inMedium, u.light, u.onLight);
                const Rgb throughput = path.throughput;
                const bool goesOn = scatter(path, inMedium, u);
                any = goesOn && accel.find(path.ray, found);
                sum += throughput * lighting_.weighted(inMedium, light);
                if (!goesOn) break;
                continue;
            }
            if (arrival != Arrival::Surface) break;
        }
        counted = true;
        if (path.depth >= maxDepth) break;

        const Bsdf bsdf = hit.bsdf();
        if (bsdf.size() == 0) break;
        path.group = lighting_.groupOf(hit, bsdf);
        if (albedoWanted) std::exchange(albedoWanted, nullptr)->albedo = unitAlbedo(bsdf, hit.wo);
        if (sinks.gBuffer && path.depth == 0)
            sinks.gBuffer->record(path.throughput * path.passing, hit, bsdf, path.distance);
        const BsdfView view(bsdf, hit.wo);
        const VertexNumbers u(sampler);
        DirectLighting::Proposal light;
        if (bsdf.hasNonSpecular()) light = lighting_.propose(hit, view, path.group, u.light, u.onLight);
        const Rgb throughput = path.throughput;
        const int depth = path.depth;
        const bool goesOn = scatter(path, hit, view, u);
        // The path's own ray is traced before the shadow ray, which then hides the latency of loading the surface's
        // data.
        any = goesOn && accel.find(path.ray, found);
        if (directWanted && depth > 0) *std::exchange(directWanted, nullptr) = sum;
        sum += throughput * lighting_.weighted(hit, light);
        if (!goesOn) break;
    }
    if (directWanted) *directWanted = sum;
    const Rgb bounded = clampedSample(sum, settings_.clamp);
    // The direct part is scaled together with the whole.
    if (direct && bounded != sum) *direct = partOfClamped(*direct, sum, settings_.clamp);
    return bounded;
}

}  // namespace drc
