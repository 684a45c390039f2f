#include "transport/bdpt.h"

#include <cmath>

namespace drc {
namespace {

// Maximum number of vertices of a subpath, specular ones included.
constexpr size_t kMostVertices = 192;

// Converts a pdf per solid angle at `from` to one per area at the surface point `to`.
float perArea(float perSolidAngle, const Vec3& from, const SurfaceInteraction& to) {
    const Vec3 d = to.p - from;
    const float squared = lengthSquared(d);
    return perSolidAngle * absDot(to.ng, d) / (squared * std::sqrt(squared));
}

// Correction for shading normals in light transport: where the shading normal differs from the geometric normal, light
// paths and camera paths use different cosines (Veach 1997, section 5.3).
float shadingOfLight(const Bsdf& bsdf, const SurfaceInteraction& at) {
    const float cosine = absDot(at.ng, at.wo);
    return cosine > 0 ? absDot(bsdf.frame().n, at.wo) / cosine : 0;
}

// Whether the shape is turned towards each ray. Its points and normals are then defined by camera paths: light paths
// arrive from other directions, find other points and normals, and cannot be weighted against camera paths. So light
// paths end there.
bool facesRays(const SurfaceInteraction& at) { return at.primitive->shape && at.primitive->shape->facesRays(); }

}  // namespace

// A subpath vertex on a surface.
struct BidirectionalTracer::Vertex {
    SurfaceInteraction hit;
    Bsdf bsdf;            // as seen from hit.wo
    Rgb throughput{1.f};  // of the subpath up to this vertex, without its BSDF
    float own = 0;        // pdf per area when sampled from the subpath's own end
    float reverse = 0;    // pdf per area when sampled from the opposite end; set once the next vertex is scattered
    bool specular = false;
    bool oneWay = false;  // specular, and the reversed path would be mirrored in another direction
    int scattered = 0;    // number of non-specular vertices before this one

    // For the vertex of a light path: the throughput scattered in direction d, without the cosine. Not every BSDF is
    // reciprocal, so it is evaluated with the directions and the shading normal that a camera path would have.
    Rgb scatteredTo(const Vec3& d) const {
        const Bsdf seen = bsdf.seenFrom(d);
        return throughput * shadingOfLight(seen, hit) * seen.f(d, hit.wo, LobeFlags::NonSpecular);
    }
    // Pdf, per solid angle, with which a path that arrives from direction d is scattered to direction hit.wo.
    float pdfBack(const Vec3& d) const { return bsdf.seenFrom(d).pdf(d, hit.wo); }

    // Surfaces that are hidden from diffuse rays are visible only to the camera, directly or through mirrors and smooth
    // glass. A light path cannot tell whether the rest of the path, up to the camera, will be specular. So it passes
    // through such surfaces, as diffuse rays do, and if the scene has any, it ends at its first specular vertex; camera
    // paths cover all that light paths leave out. joined: whether the path leaves this vertex by its non-specular
    // lobes.
    Node node(const Accel& accel, bool joined = false) const {
        const bool mirrors = specular && !joined;
        const bool hidden = accel.hidesFromDiffuse() && (mirrors || !hit.primitive->visibleToDiffuse);
        return {own, reverse, mirrors, hidden || facesRays(hit) || (mirrors && oneWay)};
    }
};

struct BidirectionalTracer::LightEnd {
    Vec3 p{0.f}, ng{0.f};
    Vec3 d{0.f};  // direction of the emitted light
    bool infinite = false, delta = false;
    bool startsPaths = false;  // whether light paths start at this light
    EmissionDensity density;   // `origin` includes the probability of choosing the light
    float chosen = 0;          // see Ends::chosen

    // Pdf per area of the light's point (per solid angle of its direction if it is infinite), converted from a pdf per
    // solid angle at the point `other`.
    float from(const Vec3& other, float perSolidAngle) const {
        return infinite ? perSolidAngle : perSolidAngle * absDot(ng, d) / lengthSquared(p - other);
    }
    // Pdf per area of the first vertex of a path that starts at the light.
    float to(const SurfaceInteraction& next) const {
        return infinite ? density.leaving * absDot(next.ng, d) : perArea(density.leaving, p, next);
    }
};

struct BidirectionalTracer::Paths {
    std::vector<Vertex> camera, light;
    Vec3 lens{0.f};
    bool lensCanBeJoined = false;
    LightEnd end;             // the start of `light`
    float endFromCamera = 0;  // pdf of its point when sampled from the first vertex of `light`, once that is scattered
    // Scratch memory for the MIS weights.
    std::vector<Node> nodes;
    Ends ends;

    Paths() {
        camera.reserve(kMostVertices);
        light.reserve(kMostVertices);
    }
};

// The continuation of a subpath from one vertex to the next.
struct BidirectionalTracer::Step {
    Ray ray;
    Rgb throughput;
    float pdf = 0, reverse = 0;  // per solid angle; 1 for specular lobes
    float eta = 1;

    // Samples the BSDF. False if the path ends. Marks the vertex as specular if a specular lobe was sampled.
    bool sample(Vertex& at, float uLobe, const Vec2& u, TransportMode mode) {
        const BsdfView view(at.bsdf, at.hit.wo, LobeFlags::All, mode);
        const auto s = view.sample(uLobe, u);
        if (!s || !(s->pdf > 0)) return false;
        const float cosine =
            mode == TransportMode::Radiance ? absDot(s->wi, at.bsdf.frame().n) : absDot(s->wi, at.hit.ng);
        at.specular = s->isSpecular();
        at.oneWay = at.specular && (at.bsdf.bentForView() || at.bsdf.seenFrom(s->wi).bentForView());
        if (mode == TransportMode::Radiance)
            throughput = at.throughput * s->f * (cosine / s->pdf);
        else if (at.specular)
            throughput = at.throughput * shadingOfLight(at.bsdf, at.hit) * s->f * (cosine / s->pdf);
        else
            throughput = at.scatteredTo(s->wi) * (cosine / s->pdf);
        if (isBlack(throughput) || !isFinite(throughput)) return false;
        pdf = at.specular ? 1 : s->pdf;
        reverse = at.specular ? 1 : at.pdfBack(s->wi);
        eta = s->eta;
        ray = at.hit.spawnRay(s->wi, spreadAfter(*s, at.hit.coneSpread));
        ray.mirrored = at.specular && mode == TransportMode::Radiance;
        return true;
    }
    // Russian roulette with survival probability min(0.95, importance). importance: the largest channel of the
    // throughput, made independent of refraction or of the light's brightness.
    bool survives(float importance, float u) {
        const float survival = std::min(0.95f, importance);
        if (u >= survival) return false;
        throughput *= 1 / survival;
        return true;
    }
};

BidirectionalTracer::BidirectionalTracer(const Scene& scene, const Camera& camera, const Accel& accel,
                                         const LightSampler& lights, const PathSettings& settings, double lightPaths)
    : camera_(camera), accel_(accel), lighting_(accel, lights), settings_(settings), lightPaths_(lightPaths) {
    const Bounds bounds = scene.bounds();
    sphere_ = {bounds.empty() ? Vec3(0.f) : bounds.center(), std::max(1e-18f, bounds.radius())};
    std::vector<float> powers;
    for (const LightPtr& light : scene.lights) {
        const float power = luminance(light->power(sphere_.radius));
        if (!(power > 0) || !light->illuminates()) continue;
        if (!light->emitsFromWhereRaysMeetIt()) continue;
        emitting_.push_back(light.get());
        powers.push_back(power);
    }
    byPower_ = Distribution1D(powers);
    for (size_t i = 0; i < emitting_.size(); ++i) probability_[emitting_[i]] = byPower_.probability(int(i));
}

float BidirectionalTracer::weight(std::span<const Node> nodes, size_t s, const Ends& ends) {
    const size_t n = nodes.size();
    // Nodes are numbered from 1, the vertex next to the lens, to n, the point on the light.
    const auto node = [&](size_t i) -> const Node& { return nodes[i - 1]; };
    size_t mostFromLight = 1;  // the light's point plus the vertices that light paths can sample after it
    while (ends.lightStartsPaths && mostFromLight < n && !node(n - mostFromLight).lightEndsBefore) ++mostFromLight;
    const auto possible = [&](size_t other) {
        const size_t t = n + 1 - other;
        if (other == 0) return ends.lightCanBeMet;
        if (other > mostFromLight) return false;
        if (t == 1 ? other < 2 || !ends.lensCanBeJoined : node(t - 1).specular) return false;
        return other == 1 || !node(t).specular;
    };
    // Factors of a strategy's pdf that are not part of the nodes' densities.
    const auto besides = [&](size_t other) {
        return (other == 1 ? double(ends.chosen) : 1.0) * (other == n ? ends.lightPaths : 1.0);
    };
    // Camera paths never sample directions above the geometric but below the shading horizon, except straight towards a
    // light. Paths with such a direction are left out here too, so that all strategies agree.
    for (size_t i = 2; i < n; ++i)
        if (!(node(i).fromCamera > 0)) return 0;
    const double own = besides(s);
    double sum = own * own, ratio = 1;
    for (size_t other = s; other-- > 0 && ratio > 0;) {
        ratio *= double(node(n - other).fromCamera) / double(node(n - other).fromLight);
        if (possible(other)) sum += sqr(ratio * besides(other));
    }
    ratio = 1;
    for (size_t other = s + 1; other <= n && ratio > 0; ++other) {
        ratio *= double(node(n + 1 - other).fromLight) / double(node(n + 1 - other).fromCamera);
        if (possible(other)) sum += sqr(ratio * besides(other));
    }
    const double share = own * own / sum;
    return std::isfinite(share) ? float(share) : 0;
}

BidirectionalTracer::LightEnd BidirectionalTracer::lightEnd(const Light& light, const EmitterHit& at, const Vec3& d,
                                                            const Vec3& from, float chosen) const {
    LightEnd end;
    end.p = at.p;
    end.ng = at.ng;
    end.d = d;
    end.infinite = light.isAtInfinity();
    end.delta = light.isDelta();
    end.density = light.emissionDensity(at, d, sphere_);
    const auto probability = probability_.find(&light);
    end.startsPaths = probability != probability_.end();
    if (end.startsPaths) end.density.origin *= probability->second;
    const float here = end.delta ? chosen : end.from(from, chosen);
    end.chosen = end.density.origin > 0 ? here / end.density.origin : 0;
    return end;
}

BidirectionalTracer::LightEnd BidirectionalTracer::lightEnd(const Light& light, const EmitterHit& at, const Vec3& d,
                                                            const Vec3& from) const {
    float chosen = lighting_.lights().probability(from, &light);
    if (light.isInfinite()) {
        chosen *= light.pdfEscaped(from, -d);
    } else if (!light.isDelta()) {
        chosen *= static_cast<const AreaLight&>(light).pdf(from, -d, at);
    }
    return lightEnd(light, at, d, from, chosen);
}

Rgb BidirectionalTracer::radiance(const Ray& cameraRay, Sampler& sampler, std::vector<Splat>& splats,
                                  GBufferSample* gBuffer) const {
    thread_local Paths paths;
    const size_t before = splats.size();
    Rgb sum = traceCamera(cameraRay, sampler, paths, gBuffer);
    traceLight(cameraRay.time, sampler, paths, splats);
    for (size_t i = 0; i < paths.camera.size(); ++i)
        for (size_t j = 0; j < paths.light.size(); ++j) sum += join(paths, i, j);
    for (size_t i = before; i < splats.size(); ++i)
        splats[i].radiance = clampedSample(splats[i].radiance, settings_.clamp);
    return clampedSample(sum, settings_.clamp);
}

Rgb BidirectionalTracer::traceCamera(const Ray& cameraRay, Sampler& sampler, Paths& paths,
                                     GBufferSample* gBuffer) const {
    paths.camera.clear();
    paths.lens = cameraRay.o;
    paths.lensCanBeJoined = camera_.pixelsPerArea(cameraRay, 1) > 0;
    Rgb sum(0.f);
    Step step{cameraRay, Rgb(1.f)};
    float etaScale = 1, distance = 0;
    int scattered = 0;
    for (;;) {
        SurfaceInteraction hit;
        const bool first = paths.camera.empty();
        const Vec3 from = first ? paths.lens : paths.camera.back().hit.p;
        float own = 0;  // pdf per area of the surface point that was hit
        // Emission that the camera path hits is weighted against all other strategies; at the first hit there is no
        // other.
        const auto add = [&](const Light& light, const Rgb& radiance, const EmitterHit& at, const Vec3& d,
                             float density) {
            const Rgb emitted = step.throughput * radiance;
            if (first || isBlack(emitted))
                sum += emitted;
            else
                sum += emitted * weightOfMet(paths, lightEnd(light, at, d, from), density);
        };
        const Arrival arrival = toSurface(accel_, step.ray, hit, [&](const SurfaceInteraction& surface) {
            distance += surface.t;
            if (gBuffer && first) gBuffer->meet(surface);
            own = first ? camera_.pixelsPerArea(cameraRay, length(surface.p - from)) * absDot(surface.ng, surface.wo)
                        : perArea(step.pdf, from, surface);
            DirectLighting::forLightAt(surface, [&](const AreaLight& light, const Rgb& radiance) {
                add(light, radiance, surface.emitterHit(), surface.wo, own);
            });
        });
        if (arrival == Arrival::Escaped)
            lighting_.forLightsAtInfinity(from, step.ray, [&](const Light& light, const Rgb& radiance) {
                add(light, radiance, {}, -step.ray.d, step.pdf);
            });
        if (gBuffer && arrival != Arrival::Escaped) gBuffer->covered = true;
        if (arrival != Arrival::Surface) break;
        if (scattered >= settings_.maxDepth || paths.camera.size() == kMostVertices) break;
        Vertex& at = paths.camera.emplace_back();
        at.hit = hit;
        at.bsdf = hit.bsdf();
        at.throughput = step.throughput;
        at.own = own;
        at.scattered = scattered;
        if (gBuffer && scattered == 0) gBuffer->record(at.throughput, hit, at.bsdf, distance);
        const auto u = sampler.getFour2D();
        if (at.bsdf.hasNonSpecular()) sum += sampleLight(paths, u[2].x, u[0]);
        if (!step.sample(at, u[2].y, u[1], TransportMode::Radiance)) break;
        if (!first) {
            Vertex& previous = paths.camera[paths.camera.size() - 2];
            previous.reverse = perArea(step.reverse, hit.p, previous.hit);
        }
        if (!at.specular) ++scattered;
        etaScale *= sqr(step.eta);
        if (int(paths.camera.size()) >= settings_.rouletteDepth &&
            !step.survives(maxComponent(step.throughput) * etaScale, u[3].x))
            break;
    }
    return sum;
}

void BidirectionalTracer::traceLight(float time, Sampler& sampler, Paths& paths, std::vector<Splat>& splats) const {
    paths.light.clear();
    if (emitting_.empty()) return;
    const auto numbers = sampler.getFour2D();
    const DiscreteSample choice = byPower_.sampleDiscrete(numbers[2].x);
    const Light& light = *emitting_[size_t(choice.index)];
    const auto emitted = light.emit(numbers[0], numbers[1], sphere_);
    if (!emitted) return;
    const float density = choice.probability * emitted->density.origin * emitted->density.leaving;
    const bool surface = lengthSquared(emitted->ng) > 0;
    const float cosine = surface ? absDot(emitted->ng, emitted->d) : 1;
    Step step;
    step.throughput = emitted->radiance * (cosine / density);
    if (!isFinite(step.throughput) || isBlack(step.throughput)) return;
    step.ray.o =
        surface ? SpawnPoint{emitted->p, emitted->ng, 0, emitted->error + roundingError(emitted->p)}.towards(emitted->d)
                : emitted->p;
    step.ray.d = emitted->d;
    step.ray.time = time;
    step.ray.coneSpread = kDiffuseSpread;
    const float start = maxComponent(step.throughput);
    int scattered = 0;
    for (;;) {
        SurfaceInteraction hit;
        if (toSurface(accel_, step.ray, hit, [](const SurfaceInteraction&) {}) != Arrival::Surface) break;
        if (scattered >= settings_.maxDepth || paths.light.size() == kMostVertices || facesRays(hit)) break;
        const bool first = paths.light.empty();
        // A point outside a portal receives no light through it.
        if (first && light.isInfinite() && isBlack(light.escaped(hit.p, -emitted->d))) break;
        if (first)
            paths.end = lightEnd(light, {emitted->p, emitted->ng, emitted->triangle, emitted->uv}, emitted->d, hit.p);
        const float own = first ? paths.end.to(hit) : perArea(step.pdf, paths.light.back().hit.p, hit);
        Vertex& at = paths.light.emplace_back();
        at.hit = hit;
        at.bsdf = hit.bsdf();
        at.throughput = step.throughput;
        at.own = own;
        at.scattered = scattered;
        const auto u = sampler.getFour2D();
        if (at.bsdf.hasNonSpecular()) joinLens(paths, time, u[0], splats);
        if (!step.sample(at, u[2].y, u[1], TransportMode::Importance)) break;
        if (at.node(accel_).lightEndsBefore) break;
        if (first) {
            paths.endFromCamera = paths.end.from(hit.p, step.reverse);
        } else {
            Vertex& previous = paths.light[paths.light.size() - 2];
            previous.reverse = perArea(step.reverse, hit.p, previous.hit);
        }
        if (!at.specular) ++scattered;
        if (int(paths.light.size()) >= settings_.rouletteDepth &&
            !step.survives(maxComponent(step.throughput) / start, u[3].x))
            break;
    }
}

Rgb BidirectionalTracer::sampleLight(Paths& paths, float uLight, const Vec2& u) const {
    const Vertex& at = paths.camera.back();
    const BsdfView view(at.bsdf, at.hit.wo);
    auto proposal = lighting_.propose(at.hit, view, DirectLighting::kNoGroup, uLight, u);
    const Rgb light = at.throughput * lighting_.arriving(at.hit, proposal);
    if (isBlack(light) || proposal.screened) return light;
    const LightSample& s = proposal.sample;
    EmitterHit point{Vec3(0.f), s.ng, s.triangle, s.uv};
    if (!std::isinf(s.distance)) point.p = at.hit.p + s.wi * s.distance;
    const LightEnd end = lightEnd(*proposal.light, point, -s.wi, at.hit.p, proposal.lightPdf);
    return light * weightOfSampled(paths, end, s.wi, proposal.bsdfPdf);
}

void BidirectionalTracer::joinLens(Paths& paths, float time, const Vec2& uLens, std::vector<Splat>& splats) const {
    const Vertex& at = paths.light.back();
    const auto view = camera_.view(at.hit.p, uLens, time);
    if (!view) return;
    const Vec3 way = view->from - at.hit.p;
    const float distance = length(way);
    if (!(distance > 0)) return;
    const Vec3 d = way / distance;
    const float fromCamera = view->pixelsPerArea * absDot(at.hit.ng, d);
    const Rgb light = at.scatteredTo(d) * fromCamera;
    if (isBlack(light) || hiddenFromLens(accel_, at.hit, d, distance)) return;
    splats.push_back({view->film, light * (weightAtLens(paths, d, fromCamera) / float(lightPaths_))});
}

Rgb BidirectionalTracer::join(Paths& paths, size_t camera, size_t light) const {
    const Vertex &z = paths.camera[camera], &y = paths.light[light];
    if (z.scattered + y.scattered + 2 > settings_.maxDepth) return Rgb(0.f);
    if (!z.bsdf.hasNonSpecular() || !y.bsdf.hasNonSpecular()) return Rgb(0.f);
    const Vec3 way = y.hit.p - z.hit.p;
    const float distance = length(way);
    if (!(distance > 0)) return Rgb(0.f);
    const Vec3 d = way / distance;
    Rgb sum = z.throughput * z.bsdf.f(z.hit.wo, d, LobeFlags::NonSpecular);
    if (isBlack(sum)) return sum;
    sum *= y.scatteredTo(-d);
    sum *= absDot(z.bsdf.frame().n, d) * absDot(y.hit.ng, d) / sqr(distance);
    if (isBlack(sum) || screened(accel_, z.hit.spawnPoint(), d, y.hit.spawnPoint(), z.hit.time)) return Rgb(0.f);
    return sum * weightOfJoined(paths, camera, light, d);
}

float BidirectionalTracer::weight(const Paths& paths, size_t s) const { return weight(paths.nodes, s, paths.ends); }

float BidirectionalTracer::weightOfMet(Paths& paths, const LightEnd& end, float fromCamera) const {
    paths.nodes.clear();
    for (const Vertex& v : paths.camera) paths.nodes.push_back(v.node(accel_));
    paths.nodes.back().fromLight = end.to(paths.camera.back().hit);
    paths.nodes.push_back({fromCamera, end.density.origin, false});
    paths.ends = {end.chosen, !end.delta, paths.lensCanBeJoined, lightPaths_, end.startsPaths};
    return weight(paths, 0);
}

float BidirectionalTracer::weightOfSampled(Paths& paths, const LightEnd& end, const Vec3& wi, float pdf) const {
    paths.nodes.clear();
    for (const Vertex& v : paths.camera) paths.nodes.push_back(v.node(accel_));
    const size_t last = paths.camera.size() - 1;
    const Vertex& at = paths.camera[last];
    paths.nodes[last] = at.node(accel_, true);
    paths.nodes[last].fromLight = end.to(at.hit);
    if (last > 0) paths.nodes[last - 1].fromLight = perArea(at.pdfBack(wi), at.hit.p, paths.camera[last - 1].hit);
    paths.nodes.push_back({end.delta ? 0 : end.from(at.hit.p, pdf), end.density.origin, false});
    paths.ends = {end.chosen, !end.delta, paths.lensCanBeJoined, lightPaths_, end.startsPaths};
    return weight(paths, 1);
}

void BidirectionalTracer::appendLight(Paths& paths, size_t first, float fromCamera, float nextFromCamera) const {
    const std::vector<Vertex>& light = paths.light;
    paths.nodes.push_back({fromCamera, light[first].own, false});
    for (size_t i = first; i-- > 0;)
        paths.nodes.push_back({i + 1 == first ? nextFromCamera : light[i].reverse, light[i].own, light[i].specular});
    paths.nodes.push_back({first == 0 ? nextFromCamera : paths.endFromCamera, paths.end.density.origin, false});
    paths.ends = {paths.end.chosen, !paths.end.delta, paths.lensCanBeJoined, lightPaths_, paths.end.startsPaths};
}

float BidirectionalTracer::weightOfJoined(Paths& paths, size_t camera, size_t light, const Vec3& d) const {
    const Vertex &z = paths.camera[camera], &y = paths.light[light];
    paths.nodes.clear();
    for (size_t i = 0; i <= camera; ++i) paths.nodes.push_back(paths.camera[i].node(accel_));
    paths.nodes[camera] = z.node(accel_, true);
    paths.nodes[camera].fromLight = perArea(y.bsdf.pdf(y.hit.wo, -d), y.hit.p, z.hit);
    if (camera > 0) paths.nodes[camera - 1].fromLight = perArea(z.pdfBack(d), z.hit.p, paths.camera[camera - 1].hit);
    const float back = y.pdfBack(-d);
    appendLight(paths, light, perArea(z.bsdf.pdf(z.hit.wo, d), z.hit.p, y.hit),
                light > 0 ? perArea(back, y.hit.p, paths.light[light - 1].hit) : paths.end.from(y.hit.p, back));
    return weight(paths, light + 2);
}

float BidirectionalTracer::weightAtLens(Paths& paths, const Vec3& d, float fromCamera) const {
    const size_t last = paths.light.size() - 1;
    const Vertex& y = paths.light[last];
    paths.nodes.clear();
    const float back = y.pdfBack(d);
    appendLight(paths, last, fromCamera,
                last > 0 ? perArea(back, y.hit.p, paths.light[last - 1].hit) : paths.end.from(y.hit.p, back));
    return weight(paths, last + 2);
}

}  // namespace drc
