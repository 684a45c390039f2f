// Direct lighting for every integrator: Le at surfaces that rays hit and at infinity, and light samples at the vertices
// of paths, with the pdfs and weights of multiple importance sampling (Veach 1997, chapter 9). Radiance is linear RGB.
#pragma once
#include "scene/lobes/bsdf_view.h"
#include "transport/environment_guide.h"
#include "transport/light_sampler.h"
#include "transport/medium_segment.h"
#include "transport/ray_queries.h"

namespace drc {

// Veach's power heuristic with exponent 2: the weight of the technique whose pdf is `a`.
inline float powerHeuristic(float a, float b) {
    const float a2 = a * a, b2 = b * b;
    return a2 > 0 ? a2 / (a2 + b2) : 0;
}

class DirectLighting {
  public:
    // No group of the guide: light samples are not guided.
    static constexpr int kNoGroup = -1;
    // As a pdf: marks a direction that light sampling cannot produce, from the camera or from a specular lobe.
    static constexpr float kSpecular = 0;

    // Both arguments must outlive this object.
    DirectLighting(const Accel& accel, const LightSampler& lights) : accel_(accel), lights_(lights) {}

    // From now on, samples of the guide's light are guided, and the guide learns which of them are unoccluded. Null
    // turns guiding off.
    void setGuide(EnvironmentGuide* guide) { guide_ = guide; }
    // The guide's group for a point on a surface; kNoGroup without a guide.
    int groupOf(const SurfaceInteraction& at, const Bsdf& bsdf) const {
        if (guide_ == nullptr) return kNoGroup;
        const int group = guide_->group(at.p, faceForward(bsdf.frame().n, at.wo));
        guide_->prefetch(group);
        return group;
    }

    // Calls met(light, Le) for the emitter that the ray hit, if the surface emits towards it.
    template <class Met>
    static void forLightAt(const SurfaceInteraction& hit, Met&& met) {
        const AreaLight* light = hit.primitive->areaLight.get();
        if (light == nullptr) return;
        const Rgb emitted = hit.emitted();
        if (!isBlack(emitted)) met(*light, emitted);
    }
    // Calls met(light, Le) for every light at infinity that shines along `ray`, which left `from` and escaped.
    template <class Met>
    void forLightsAtInfinity(const Vec3& from, const Ray& ray, Met&& met) const {
        for (const Light* light : ray.fromCamera ? lights_.backdrop() : lights_.infiniteLights()) {
            const Rgb radiance = light->escaped(from, ray.d);
            if (!isBlack(radiance)) met(*light, radiance);
        }
    }

    // Le along a ray that left `from` in a direction sampled with `pdf` per solid angle, times the MIS weight against
    // light sampling at `from` (1 for kSpecular).
    Rgb emissionAtHit(const SurfaceInteraction& hit, const Vec3& from, float pdf) const;
    Rgb emissionAtInfinity(const Ray& ray, const Vec3& from, float pdf, int group) const;

    // A light sample at a vertex, before its visibility is known.
    struct Proposal {
        const Light* light = nullptr;  // null: nothing was sampled
        LightSample sample{};
        Rgb throughput{0.f};  // BSDF times cosine, or phase function, divided by lightPdf
        float lightPdf = 0;   // per solid angle, including the choice of the light
        float bsdfPdf = 0;    // of BSDF or phase function sampling for the same direction
        int slot = -1;        // where the guide learns the sample's visibility; -1: not guided
        // Whether the path's own ray to the light would be blocked although the shadow ray is not (see screened()), so
        // that no other technique finds this light.
        bool screened = false;
        // The MIS weight against BSDF sampling.
        float weight() const { return sample.delta || screened ? 1 : powerHeuristic(lightPdf, bsdfPdf); }
    };
    // uLight chooses the light, u the direction or the point on the light.
    Proposal propose(const SurfaceInteraction& at, const BsdfView& bsdf, int group, float uLight, const Vec2& u) const;
    Proposal propose(const MediumVertex& at, float uLight, const Vec2& u) const;
    // The sample's contribution without weight(): throughput times Le, or black if the shadow ray is blocked. Sets
    // proposal.screened.
    Rgb arriving(const SurfaceInteraction& at, Proposal& proposal) const {
        if (proposal.light == nullptr) return Rgb(0.f);
        return arriving(at.spawnPoint(), at.mediumTowards(proposal.sample.wi), at.time, proposal);
    }
    Rgb arriving(const MediumVertex& at, Proposal& proposal) const {
        if (proposal.light == nullptr) return Rgb(0.f);
        return arriving(at.spawnPoint(), at.medium, at.time, proposal);
    }
    // arriving() times weight().
    template <class Vertex>
    Rgb weighted(const Vertex& at, Proposal& proposal) const {
        const Rgb light = arriving(at, proposal);
        return light * proposal.weight();
    }

    const Accel& accel() const { return accel_; }
    const LightSampler& lights() const { return lights_; }

  private:
    // scattered(wi): BSDF times cosine, or phase function, and the pdf of sampling that direction.
    template <class Scattered>
    Proposal propose(const Vec3& p, int group, float uLight, const Vec2& u, Scattered&& scattered) const;
    Rgb arriving(const SpawnPoint& from, const Medium* medium, float time, Proposal& proposal) const;

    const Accel& accel_;
    const LightSampler& lights_;
    EnvironmentGuide* guide_ = nullptr;
};

}  // namespace drc
