#include "cache/gather.h"

#include "scene/bsdf_view.h"

namespace drc {
namespace {

struct Sides {
    const RadianceMap* front = nullptr;
    const RadianceMap* back = nullptr;  // null: the pixel does not transmit
    float pdf(const Vec3& d) const { return back ? 0.5f * (front->pdf(d) + back->pdf(d)) : front->pdf(d); }
};

}  // namespace

Rgb gather(const PrimaryHit& hit, std::span<const WeightedSite> sites, int samples, uint64_t stream,
           uint32_t firstIndex) {
    const SurfaceInteraction& at = hit.surface;
    const Vec3 normal = faceForward(at.ng, at.wo);
    const bool transmits = hit.bsdf.hasWideTransmission();
    const Vec3& shading = hit.bsdf.frame().n;
    float total = 0;
    for (const WeightedSite& s : sites) total += s.weight;

    // The maps' density follows what a diffuse surface integrates: there the BSDF's own samples would add but noise.
    const bool glossy = hit.bsdf.has(LobeFlags::Glossy);
    const BsdfView view(hit.bsdf, at.wo, LobeFlags::Wide);
    const auto contribution = [&](const Sides& sides, const Vec3& d, float mapPdf, const LobeValue& bsdf) {
        const RadianceMap* map = dot(d, normal) >= 0 ? sides.front : sides.back;
        if (map == nullptr) return Rgb(0.f);
        // Directions between the shading and the geometric horizon, which paths never sample, are none of ours either.
        if (bsdf.pdf <= 0) return Rgb(0.f);
        return bsdf.f * map->radianceAt(at.p, d) * (absDot(d, shading) / (mapPdf + (glossy ? bsdf.pdf : 0)));
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

        const float uSide = sampler.get1D();
        const auto fromMap = (transmits && uSide < 0.5f ? site.back : site.front).sample(sampler.get2D());
        if (fromMap.pdf > 0) {
            const float mapPdf = transmits ? sides.pdf(fromMap.d) : fromMap.pdf;
            sum += contribution(sides, fromMap.d, mapPdf, view.evaluate(fromMap.d));
        }
        if (!glossy) continue;
        const float uLobe = sampler.get1D();
        const auto fromBsdf = view.sample(uLobe, sampler.get2D());
        if (fromBsdf) sum += contribution(sides, fromBsdf->wi, sides.pdf(fromBsdf->wi), {fromBsdf->f, fromBsdf->pdf});
    }
    sum *= 1.f / float(samples);
    return isFinite(sum) ? sum : Rgb(0.f);
}

}  // namespace drc
