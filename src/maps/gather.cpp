#include "maps/gather.h"

#include "scene/lobes/bsdf_view.h"

namespace drc {
namespace {

// Threshold on the cosine between the map's and the pixel's normal. Below it, the part of the pixel's hemisphere under
// the map's horizon is sampled as well; at this cosine, that part contributes 0.05 % of the irradiance.
constexpr float kParallel = 0.999f;

struct Sides {
    const RadianceMap* front = nullptr;
    const RadianceMap* back = nullptr;  // null if the pixel does not transmit
    float pdf(const Vec3& d) const { return back ? 0.5f * (front->pdf(d) + back->pdf(d)) : front->pdf(d); }
};

}  // namespace

Rgb gather(const PrimaryHit& hit, const LobeMask& lobes, std::span<const WeightedSite> sites, int samples,
           uint64_t stream, uint32_t firstIndex) {
    const SurfaceInteraction& at = hit.surface;
    const Vec3 normal = faceForward(at.ng, at.wo);
    const bool transmits = hit.bsdf.has(LobeFlags::Transmission, lobes);
    const Vec3& shading = hit.bsdf.frame().n;
    float total = 0;
    for (const WeightedSite& s : sites) total += s.weight;

    // A map's pdf is proportional to the integrand of diffuse reflection, so for purely diffuse surfaces BSDF samples
    // would only add noise. BSDF samples are needed for glossy lobes, and, where the normals of map and pixel differ,
    // for directions below the map's horizon, which the map never samples. For these, the radiance at the map's horizon
    // is the best available estimate.
    const bool glossy = hit.bsdf.has(LobeFlags::Glossy, lobes);
    const BsdfView view(hit.bsdf, at.wo, lobes);
    const auto contribution = [&](const Sides& sides, const Vec3& d, float pdf, const LobeValue& bsdf) {
        const RadianceMap* map = dot(d, normal) >= 0 ? sides.front : sides.back;
        if (map == nullptr) return Rgb(0.f);
        // Directions between the shading and the geometric horizon have BSDF pdf 0. Path tracing never samples them, so
        // gathering ignores them too.
        if (bsdf.pdf <= 0) return Rgb(0.f);
        return bsdf.f * map->radianceAt(at.p, d) * (absDot(d, shading) / pdf);
    };

    Rgb sum(0.f);
    Sampler sampler(stream, firstIndex);
    for (int i = 0; i < samples; ++i) {
        sampler.start(stream, firstIndex + uint32_t(i));
        float pick = sampler.get1D() * total;
        size_t k = 0;
        while (k + 1 < sites.size() && pick >= sites[k].weight) pick -= sites[k++].weight;
        const MapSite& site = *sites[k].site;
        const Sides sides{&site.front, transmits ? &site.back : nullptr};

        const bool both = glossy || dot(normal, site.n) < kParallel;
        const float uSide = sampler.get1D();
        const auto fromMap = (transmits && uSide < 0.5f ? site.back : site.front).sample(sampler.get2D());
        if (fromMap.pdf > 0) {
            const float mapPdf = transmits ? sides.pdf(fromMap.d) : fromMap.pdf;
            const LobeValue bsdf = view.evaluate(fromMap.d);
            sum += contribution(sides, fromMap.d, mapPdf + (both ? bsdf.pdf : 0), bsdf);
        }
        if (!both) continue;
        const float uLobe = sampler.get1D();
        const auto s = view.sample(uLobe, sampler.get2D());
        if (s) sum += contribution(sides, s->wi, sides.pdf(s->wi) + s->pdf, {s->f, s->pdf});
    }
    sum *= 1.f / float(samples);
    return isFinite(sum) ? sum : Rgb(0.f);
}

}  // namespace drc
