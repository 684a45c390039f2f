#include "transport/path_tracer.h"

#include "transport/incident_visitor.h"

namespace drc {
namespace {

// As measured, four times as many paths for glossy lobes cost 2 to 6 % of the time and reduced the error by 8 to 13 %;
// eight times as many gained no more.
constexpr float kGlossyPaths = 4;

// f_part / f_all for each channel; f_all was sampled.
Rgb ratioOf(const Rgb& part, const Rgb& all) {
    Rgb ratio(0.f);
    for (int c = 0; c < 3; ++c) ratio[c] = all[c] > 0 ? part[c] / all[c] : 0;
    return ratio;
}

// A path that leaves a primary point by its non-specular lobes. Light straight from emitters is direct light. All other
// light is indirect; only the part that the broad lobes scatter is kept, or none at all.
class ScatteredOnce : public PathVisitor {
  public:
    // traceBroad: whether to trace indirect light. All references must outlive the visitor.
    ScatteredOnce(const PathTracer& tracer, const SurfaceInteraction& at, const Bsdf& bsdf, bool traceBroad)
        : tracer_(tracer), at_(at), bsdf_(bsdf), traceBroad_(traceBroad) {}

    void emitted(const PathState& path, const Rgb& light) { add(path.throughput * light); }
    template <class Vertex>
    bool arrived(PathState& path, const Vertex&) {
        const bool isSecond = !isIndirect_;
        isIndirect_ = true;
        if (!traceBroad_ || path.depth >= tracer_.settings().maxDepth) return false;
        if (isSecond) path.throughput *= broadShare_;
        return !isBlack(path.throughput);
    }
    void lit(const LitVertex& vertex) { add(vertex.throughput * vertex.light); }
    void scattered(const PathState& path) {
        if (isIndirect_ || !traceBroad_ || !bsdf_.hasWithin(tracer_.glossy())) return;
        const LobeMask all = LobeFlags::NonSpecular;
        broadShare_ = ratioOf(bsdf_.f(at_.wo, path.ray.d, tracer_.broad()), bsdf_.f(at_.wo, path.ray.d, all));
    }

    const Rgb& direct() const { return direct_; }
    const Rgb& indirect() const { return indirect_; }

  private:
    void add(const Rgb& light) { (isIndirect_ ? indirect_ : direct_) += light; }

    const PathTracer& tracer_;
    const SurfaceInteraction& at_;
    const Bsdf& bsdf_;
    const bool traceBroad_;
    Rgb direct_{0.f}, indirect_{0.f};
    Rgb broadShare_{1.f};      // share of the broad lobes in the light scattered from the path's direction
    bool isIndirect_ = false;  // whether the path has reached its second vertex
};

}  // namespace

// D of the split: follows the chain of mirrors and smooth glass that the camera sees. At each surface of the chain, the
// non-specular lobes scatter light once.
class PathTracer::LayersVisitor : public PathVisitor {
  public:
    LayersVisitor(const PathTracer& tracer, Sampler& sampler, bool withIndirect, bool traceBroad,
                  GBufferSample* gBuffer)
        : tracer_(tracer),
          sampler_(sampler),
          broad_(tracer.broad()),
          withIndirect_(withIndirect),
          traceBroad_(traceBroad),
          gBuffer_(gBuffer) {}

    void met(const PathState&, const SurfaceInteraction& surface) {
        if (gBuffer_) gBuffer_->meet(surface);
    }
    void emitted(const PathState& path, const Rgb& light) { layers_.emission += path.throughput * light; }
    std::optional<LobeMask> leavesBy(PathState& path, const SurfaceInteraction& at, const Bsdf& bsdf) {
        if (gBuffer_) {
            gBuffer_->covered = true;
            gBuffer_->record(path.throughput, at, bsdf, path.distance);
        }
        if (bsdf.hasNonSpecular()) {
            ScatteredOnce once(tracer_, at, bsdf, traceBroad_);
            PathState branch = path;
            branch.playsRoulette = true;
            tracer_.walker_.walkFrom(at, bsdf, LobeFlags::NonSpecular, branch, sampler_, once);
            layers_.lit += once.direct();
            layers_.broad += once.indirect();
        }
        if (withIndirect_) addIndirect(path.throughput, at, bsdf);
        if (!bsdf.hasSpecular()) return {};
        return kSpecularLobes;
    }
    const SampleLayers& layers() const { return layers_; }

  private:
    void addIndirect(const Rgb& throughput, const SurfaceInteraction& at, const Bsdf& bsdf) {
        const LobeMask glossy = tracer_.glossy();
        if (bsdf.hasWithin(glossy)) {
            layers_.glossy += throughput * tracer_.indirectGlossy(at, bsdf, sampler_);
            if (isBlack(layers_.glossyAlbedo)) layers_.glossyAlbedo = throughput * bsdf.albedo(at.wo, glossy);
        }
        if (isBlack(layers_.broadAlbedo) && bsdf.hasWithin(broad_))
            layers_.broadAlbedo = throughput * bsdf.albedo(at.wo, broad_);
        if (layers_.pixelSize == 0 && bsdf.hasNonSpecular()) {
            layers_.albedo = throughput * bsdf.albedo(at.wo, LobeFlags::NonSpecular);
            layers_.position = at.p;
            layers_.normal = bsdf.frame().n;
            layers_.pixelSize = at.footprint;
        }
    }

    const PathTracer& tracer_;
    Sampler& sampler_;
    const LobeMask broad_;
    const bool withIndirect_, traceBroad_;
    GBufferSample* const gBuffer_;
    SampleLayers layers_;
};

SampleLayers PathTracer::directLayers(const Ray& cameraRay, Sampler& sampler, bool withIndirect, bool traceBroad,
                                      GBufferSample* gBuffer) const {
    LayersVisitor visitor(*this, sampler, withIndirect, traceBroad, gBuffer);
    PathState chain(cameraRay);
    chain.playsRoulette = false;
    walker_.walk(chain, sampler, visitor);
    SampleLayers layers = visitor.layers();
    // Each layer is checked by itself, so that a bad sample of one does not change the others.
    for (Rgb* light : {&layers.emission, &layers.lit})
        if (!isFinite(*light)) *light = Rgb(0.f);
    const float direct = luminance(layers.direct()), clamp = settings().clamp;
    if (direct > clamp)
        for (Rgb* light : {&layers.emission, &layers.lit}) *light *= clamp / direct;
    for (Rgb* light : {&layers.glossy, &layers.broad}) *light = clampedSample(*light, clamp);
    return layers;
}

namespace {

// Ends the chain of mirrors and smooth glass at a primary point.
class PrimaryVisitor : public PathVisitor {
  public:
    PrimaryVisitor(Sampler& sampler, PrimaryHit& result) : sampler_(sampler), result_(result) {}

    std::optional<LobeMask> leavesBy(PathState& path, const SurfaceInteraction& at, const Bsdf& bsdf) {
        const bool specular = bsdf.hasSpecular(), other = bsdf.hasNonSpecular();
        float probability = other ? 1.f : 0.f;  // of ending the chain here
        if (specular && other) {
            const float a = luminance(bsdf.albedo(at.wo, LobeFlags::NonSpecular));
            const float b = luminance(bsdf.albedo(at.wo, kSpecularLobes));
            probability = std::clamp(a / std::max(a + b, 1e-8f), 0.1f, 0.9f);
        }
        if (sampler_.get1D() < probability) {
            isFound_ = true;
            result_.surface = at;
            result_.bsdf = bsdf;
            result_.throughput = path.throughput * (1 / probability);
            result_.distance = path.distance;
            result_.bounces = path.chain;
            return {};
        }
        path.throughput *= 1 / (1 - probability);
        return kSpecularLobes;
    }
    bool isFound() const { return isFound_; }

  private:
    Sampler& sampler_;
    PrimaryHit& result_;
    bool isFound_ = false;
};

}  // namespace

bool PathTracer::primaryHit(const Ray& cameraRay, Sampler& sampler, PrimaryHit& result) const {
    PrimaryVisitor visitor(sampler, result);
    PathState chain(cameraRay);
    chain.playsRoulette = false;
    walker_.walk(chain, sampler, visitor);
    return visitor.isFound();
}

Rgb PathTracer::radiance(const Ray& ray, Sampler& sampler, const SampleParts& parts) const {
    RadianceVisitor visitor(walker_, parts);
    walker_.walk(PathState(ray), sampler, visitor);
    return visitor.finish();
}

Rgb PathTracer::incident(const Ray& ray, Sampler& sampler, FirstHit* first) const {
    IncidentVisitor visitor(walker_, first);
    walker_.walk(PathState(ray), sampler, visitor);
    return visitor.finish();
}

Rgb PathTracer::indirect(const PrimaryHit& hit, Sampler& sampler, const LobeMask& lobes) const {
    const float uLobe = sampler.get1D();
    const auto s = hit.bsdf.sample(hit.surface.wo, uLobe, sampler.get2D(), lobes);
    if (!s || !(s->pdf > 0) || isBlack(s->f)) return Rgb(0.f);
    const Ray ray = hit.surface.spawnRay(s->wi, spreadAfter(*s, hit.surface.coneSpread));
    return s->f * incident(ray, sampler) * (absDot(s->wi, hit.bsdf.frame().n) / s->pdf);
}

Rgb PathTracer::indirectGlossy(const SurfaceInteraction& at, const Bsdf& bsdf, Sampler& sampler) const {
    const float uLobe = sampler.get1D();
    const auto s = bsdf.sample(at.wo, uLobe, sampler.get2D(), glossy());
    if (!s || !(s->pdf > 0)) return Rgb(0.f);
    const Rgb weight = s->f * (absDot(s->wi, bsdf.frame().n) / s->pdf);
    // On a dark surface, even a dim reflection is most of what is seen, and no filter removes all of its noise. So
    // glossy lobes are traced several times as often as the path tracer would choose them.
    const float own = luminance(bsdf.albedo(at.wo, glossy()));
    const float all = luminance(bsdf.albedo(at.wo, LobeFlags::NonSpecular));
    const float survival = std::min(1.f, std::max(maxComponent(weight), kGlossyPaths * own / std::max(all, 1e-6f)));
    if (!(sampler.get1D() < survival)) return Rgb(0.f);
    const Ray ray = at.spawnRay(s->wi, spreadAfter(*s, at.coneSpread));
    return weight * incident(ray, sampler) * (1 / survival);
}

}  // namespace drc
