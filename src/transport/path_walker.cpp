#include "transport/path_walker.h"

#include "scene/media/henyey_greenstein.h"

namespace drc {

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
    if (!path.playsRoulette || path.depth + path.chain < settings_.rouletteDepth) return true;
    const float survival = std::min(0.95f, maxComponent(path.throughput) * path.etaScale);
    if (u >= survival) return false;
    path.throughput *= 1 / survival;
    path.weight *= 1 / survival;
    return true;
}

}  // namespace drc
