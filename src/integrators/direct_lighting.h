// Direct lighting for every integrator: Le that rays meet, and light samples at the vertices of paths, with what
// multiple importance sampling (Veach 1997, chapter 9) needs to know of both. Radiance is linear RGB.
#pragma once
#include "integrators/environment_guide.h"
#include "integrators/light_sampler.h"
#include "integrators/ray_queries.h"
#include "scene/bsdf_view.h"

namespace drc {

// Veach's power heuristic with exponent 2: the weight of the technique whose pdf is `a`.
inline float powerHeuristic(float a, float b) {
    const float a2 = a * a, b2 = b * b;
    return a2 > 0 ? a2 / (a2 + b2) : 0;
}

class DirectLighting {
  public:
    // Stands for "no group of the guide": samples there are not guided.
    static constexpr int kNoGroup = -1;
    // The pdf of a direction that no light sample could have produced: from the camera, or from a specular lobe.
    static constexpr float kSpecular = 0;

    // Both must outlive this.
    DirectLighting(const Accel& accel, const LightSampler& lights) : accel_(accel), lights_(lights) {}

    // From here on, samples of the guide's light are guided, and the guide learns which of them arrive. Null: no
    // longer.
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
    // Calls met(light, Le) for every light at infinity that shines along a ray of direction d which escaped.
    template <class Met>
    void forLightsAtInfinity(const Vec3& d, Met&& met) const {
        for (const Light* light : lights_.infiniteLights()) {
            const Rgb radiance = light->escaped(d);
            if (!isBlack(radiance)) met(*light, radiance);
        }
    }

    // Le met by a ray that left `from` in a direction sampled with `pdf` per solid angle (kSpecular: weight 1), times
    // the weight against light sampling at `from`.
    Rgb emissionAtHit(const SurfaceInteraction& hit, const Vec3& from, float pdf) const;
    Rgb emissionAtInfinity(const Vec3& d, const Vec3& from, float pdf, int group) const;

    // A light sample at a vertex, before anything is known of what may block it.
    struct Proposal {
        const Light* light = nullptr;  // null: no light
        LightSample sample{};
        Rgb throughput{0.f};  // BSDF times cosine, over lightPdf
        float lightPdf = 0;   // per solid angle, choice of the light included
        float bsdfPdf = 0;    // of the BSDF sampling the same direction
        int slot = -1;        // of the guide, which is told whether the sample arrives; -1: not guided
        // Against the BSDF's own samples.
        float weight() const { return sample.delta ? 1 : powerHeuristic(lightPdf, bsdfPdf); }
    };
    // uLight chooses the light, u the direction or the point on it.
    Proposal propose(const SurfaceInteraction& at, const BsdfView& bsdf, int group, float uLight, const Vec2& u) const;
    // What of the sample arrives: throughput times Le, or black if the shadow ray is blocked. Without weight().
    Rgb arriving(const SurfaceInteraction& at, const Proposal& proposal) const;

    const Accel& accel() const { return accel_; }
    const LightSampler& lights() const { return lights_; }

  private:
    const Accel& accel_;
    const LightSampler& lights_;
    EnvironmentGuide* guide_ = nullptr;
};

}  // namespace drc
