#include "transport/final_gather.h"

#include <array>
#include <utility>

namespace drc {
namespace {

// Beyond this number of vertices, a cache may also be asked later than at the second vertex of a path: it holds light
// of paths of nearly the full length, which is then hardly more than what the rest of the path may have.
constexpr int kLongPaths = 16;
// The number of vertices of a path that deposit. Later ones have gone through so much Russian roulette that they would
// add more noise than knowledge.
constexpr size_t kMaxDeposits = 4;
// Lobes only estimate their albedos: the others are followed with at least this probability.
constexpr float kLeastSurvival = 0.05f;

// f_part / f_all for each channel: divides the throughput of a path that was sampled through all lobes between some of
// them and the others.
Rgb shareOf(const Rgb& part, const Rgb& all) {
    Rgb share(0.f);
    for (int c = 0; c < 3; ++c) share[c] = all[c] > 0 ? std::min(1.f, part[c] / all[c]) : 0.f;
    return share;
}

// The lobes that a cache may answer for. Where the shading normal was bent for the view, or the view is below its
// horizon, each view has another normal, or samples reach other light: what is scattered then depends on the view for
// every lobe.
LobeSet lobesForCache(const Bsdf& bsdf, const Vec3& wo) {
    if (bsdf.bentForView() || dot(wo, bsdf.frame().n) * dot(wo, bsdf.ng()) <= 0) return 0;
    return bsdf.separableLobes();
}

// A vertex that a path will make a deposit for, while it is still being walked.
struct Training {
    CacheDeposit deposit;
    Rgb throughput{1.f};  // from the vertex to the latest one
    int depth = 0;        // of the vertex
};

// All vertices that a path makes deposits for.
class Trainings {
  public:
    // light: reaches the latest vertex of the path, or is scattered there, at this depth. separable: the part of it
    // that counts for the vertex itself, if that has just begun.
    void add(const Rgb& light, int depth, int maxDepth, const Rgb& separable = Rgb(1.f)) {
        for (size_t i = 0; i < count_; ++i) {
            if (!within(i, depth, maxDepth)) continue;
            const Rgb own = at_[i].throughput * light;
            at_[i].deposit.light += at_[i].depth == depth ? own * separable : own;
        }
    }
    // The path goes on. weight: of the direction. separable: as above, for the vertex that has just begun.
    void scatter(const Rgb& weight, const Rgb& separable) {
        for (size_t i = 0; i < count_; ++i) at_[i].throughput *= weight;
        if (count_ > 0) at_[count_ - 1].throughput *= separable;
    }
    bool begin(const CachePoint& at, const Rgb& viewFactor, int depth) {
        if (count_ == kMaxDeposits) return false;
        at_[count_++] = {{at, Rgb(0.f), viewFactor}, Rgb(1.f), depth};
        return true;
    }
    bool empty() const { return count_ == 0; }
    bool wantMore(int depth, int maxDepth) const { return count_ > 0 && within(count_ - 1, depth, maxDepth); }
    void deposit(std::vector<CacheDeposit>& to, float clamp) const {
        for (size_t i = 0; i < count_; ++i) {
            to.push_back(at_[i].deposit);
            to.back().light = clampedSample(to.back().light, clamp);
        }
    }

  private:
    // Every deposit holds light of paths that are one vertex shorter than those of the camera.
    bool within(size_t i, int depth, int maxDepth) const { return depth - at_[i].depth < maxDepth - 1; }

    std::array<Training, kMaxDeposits> at_;
    size_t count_ = 0;
};

}  // namespace

Rgb FinalGather::radiance(const Ray& ray, Sample& sample) const {
    Pcg32 random(sample.seed);
    const float clamp = walker_.settings().clamp;
    const Rgb sum = follow(PathState(ray), sample, random);
    if (Rgb* direct = sample.sinks.direct) *direct = partOfClamped(*direct, sum, clamp);
    return clampedSample(sum, clamp);
}

Rgb FinalGather::follow(PathState path, Sample& sample, Pcg32& random) const {
    const PathSettings& settings = walker_.settings();
    const RadianceCache& cache = sample.cache;
    Counts& counts = sample.counts;
    Rgb sum(0.f);
    // The part of the path's throughput that the picture shows. Where the cache has answered for the separable lobes,
    // it is that of the others.
    Rgb share(1.f);
    bool shown = true;  // whether share is not zero
    Trainings trainings;
    Rgb* directWanted = sample.sinks.direct;
    // All that has been met before the second vertex is direct light.
    const auto recordDirect = [&](bool ends) {
        if (directWanted && (ends || path.depth > 0)) *std::exchange(directWanted, nullptr) = sum;
    };
    // Since the last non-specular vertex, and of its direction.
    float distance = 0, pdf = path.pdf;
    const Accel& accel = lighting_.accel();
    SurfaceInteraction hit;
    MediumVertex inMedium;
    Accel::Found found;
    bool any = accel.find(path.ray, found);
    for (;;) {
        const auto emitted = [&](const Rgb& light) {
            if (isBlack(light)) return;
            if (shown) sum += path.throughput * share * light;
            trainings.add(light, path.depth - 1, settings.maxDepth);
        };
        const auto met = [&](const SurfaceInteraction& surface) {
            path.distance += surface.t;
            distance += surface.t;
            emitted(lighting_.emissionAtHit(surface, path.from, path.pdf));
        };
        const auto passed = [&](const Rgb& light, const Rgb& weight) {
            emitted(light);
            trainings.scatter(weight, Rgb(1.f));
        };
        const Arrival arrival =
            walker_.advance(path, any, found, hit, inMedium, sample.sampler, sample.sinks.gBuffer, met, passed);
        if (arrival == Arrival::Escaped)
            emitted(lighting_.emissionAtInfinity(path.ray, path.from, path.pdf, path.group));
        if (arrival == Arrival::Scattered) {
            recordDirect(false);
            if (path.depth >= settings.maxDepth) shown = false;
            if (!shown && !trainings.wantMore(path.depth, settings.maxDepth)) break;
            const VertexNumbers u(sample.sampler);
            DirectLighting::Proposal light = lighting_.propose(inMedium, u.light, u.onLight);
            const Rgb throughput = path.throughput;
            const int depth = path.depth;
            const bool goesOn = walker_.scatter(path, inMedium, u);
            any = goesOn && accel.find(path.ray, found);
            const Rgb lit = lighting_.weighted(inMedium, light);
            if (shown) sum += throughput * share * lit;
            trainings.add(lit, depth, settings.maxDepth);
            if (!goesOn) break;
            distance = 0;
            pdf = path.pdf;
            trainings.scatter(path.weight, Rgb(1.f));
            continue;
        }
        if (arrival != Arrival::Surface) break;
        recordDirect(false);
        if (path.depth >= settings.maxDepth) shown = false;
        if (!shown && !trainings.wantMore(path.depth, settings.maxDepth)) break;

        const bool mayAsk = path.depth == 1 || (path.depth > 1 && settings.maxDepth >= kLongPaths);
        const CachePoint at{hit.p, faceForward(hit.ng, hit.wo), CachePoint::reachOf(distance, pdf)};
        const bool accepted = mayAsk && cache.accepts(at);
        if (accepted && shown) cache.prefetch(at);
        const Bsdf bsdf = hit.bsdf();
        if (bsdf.size() == 0) break;
        path.group = lighting_.groupOf(hit, bsdf);
        if (sample.sinks.gBuffer && path.depth == 0)
            sample.sinks.gBuffer->record(path.throughput * path.passing, hit, bsdf, path.distance);

        bool answered = false, trainsHere = false;
        const LobeSet shared = mayAsk ? lobesForCache(bsdf, hit.wo) : LobeSet(0);
        const LobeMask separable(LobeFlags::All, shared), others(LobeFlags::All, LobeSet(~shared));
        const bool mixed = bsdf.hasWithin(others);
        if (shared != 0) {
            if (!accepted) {
                ++counts.refused;
            } else {
                const Rgb factor = cacheableFactor(bsdf.viewFactor(hit.wo, shared));
                if (shown) {
                    ++counts.asked;
                    CacheAnswer answer;
                    answered = cache.lookUp(at, answer);
                    if (answered) {
                        ++counts.answered;
                        sum += path.throughput * share * factor * answer.perFactor;
                        shown = mixed;
                    }
                    // Deposits are made where look-ups are, and nowhere else, so that both have the same distribution.
                    trainsHere = random.nextFloat() < answer.training * sample.training &&
                                 trainings.begin(at, factor, path.depth);
                }
            }
        }
        if (!shown && trainings.empty()) break;

        // A path that trains is sampled through all lobes, another one through those that are still to be shown, as
        // often as the path tracer would choose them.
        const bool othersAlone = answered && trainings.empty();
        if (othersAlone) {
            const float own = maxComponent(bsdf.albedo(hit.wo, others)), all = maxComponent(bsdf.albedo(hit.wo));
            const float survival = std::clamp(own / std::max(all, 1e-8f), kLeastSurvival, 1.f);
            if (random.nextFloat() >= survival) break;
            path.throughput *= 1 / survival;
        }
        const LobeMask sampled = othersAlone ? others : LobeMask(LobeFlags::All);
        // f_separable / f_all for a direction, where one sample of all lobes serves two estimates: the deposit takes
        // this share; the picture takes the rest if the cache answered for the separable lobes.
        const bool divided = mixed && !othersAlone && (answered || trainsHere);
        const auto separableShare = [&](const Vec3& wi) {
            return divided ? shareOf(bsdf.f(hit.wo, wi, separable), bsdf.f(hit.wo, wi)) : Rgb(1.f);
        };

        const BsdfView view(bsdf, hit.wo, sampled);
        const VertexNumbers u(sample.sampler);
        DirectLighting::Proposal light;
        if (bsdf.hasWithin(LobeMask(LobeFlags::NonSpecular, sampled.lobes)))
            light = lighting_.propose(hit, view, path.group, u.light, u.onLight);
        const Rgb throughput = path.throughput;
        const int depth = path.depth;
        const bool goesOn = walker_.scatter(path, hit, view, u);
        // The path's own ray is traced before the shadow ray, which then hides the latency of loading the surface's
        // data.
        any = goesOn && accel.find(path.ray, found);
        const Rgb lit = lighting_.weighted(hit, light);
        if (!isBlack(lit)) {
            const Rgb part = separableShare(light.sample.wi);
            if (shown) sum += throughput * share * (divided && answered ? lit * (Rgb(1.f) - part) : lit);
            trainings.add(lit, depth, settings.maxDepth, trainsHere ? part : Rgb(1.f));
        }
        if (!goesOn) break;

        const bool specular = path.pdf == DirectLighting::kSpecular;
        if (!specular) {
            distance = 0;
            pdf = path.pdf;
        }
        if (divided || trainsHere) {
            const Rgb part = specular ? Rgb(0.f) : separableShare(path.ray.d);
            if (divided && answered) share *= Rgb(1.f) - part;
            trainings.scatter(path.weight, trainsHere ? part : Rgb(1.f));
        } else {
            trainings.scatter(path.weight, Rgb(1.f));
        }
    }
    recordDirect(true);
    trainings.deposit(sample.deposits, settings.clamp);
    return sum;
}

}  // namespace drc
