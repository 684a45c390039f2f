#include "transport/final_gather.h"

#include <array>

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

// The path tracer's visitor, whose paths may end in the cache. Beside what it shows, a path sums the light for the
// deposits that it makes on its way.
class GatherVisitor : public RadianceVisitor {
  public:
    GatherVisitor(const PathWalker& walker, FinalGather::Sample& sample)
        : RadianceVisitor(walker, sample.parts),
          sample_(sample),
          maxDepth_(walker.settings().maxDepth),
          random_(sample.seed) {}

    void passed(const PathState& path, const MediumPassage& passage) {
        RadianceVisitor::passed(path, passage);
        trainings_.scatter(passage.end.weight, Rgb(1.f));
    }
    void met(const PathState&, const SurfaceInteraction& surface) { distance_ += surface.t; }
    void emitted(const PathState& path, const Rgb& light) {
        if (isBlack(light)) return;
        if (shown_) add(path.throughput * share_ * light);
        trainings_.add(light, path.depth - 1, maxDepth_);
    }
    bool arrived(const PathState& path, const MediumVertex&) {
        at_ = nullptr;
        answered_ = trainsHere_ = divided_ = false;
        return isWanted(path);
    }
    bool arrived(const PathState& path, const SurfaceInteraction& surface) {
        if (!isWanted(path)) return false;
        at_ = &surface;
        mayAsk_ = path.depth == 1 || (path.depth > 1 && maxDepth_ >= kLongPaths);
        point_ = {surface.p, faceForward(surface.ng, surface.wo), CachePoint::reachOf(distance_, pdf_)};
        accepted_ = mayAsk_ && sample_.cache.accepts(point_);
        // The cell is loaded while the BSDF is computed.
        if (accepted_ && shown_) sample_.cache.prefetch(point_);
        return true;
    }
    std::optional<LobeMask> leavesBy(PathState& path, const SurfaceInteraction& surface, const Bsdf& bsdf) {
        noteSurface(path, surface, bsdf);
        bsdf_ = &bsdf;
        const LobeSet separable = mayAsk_ ? lobesForCache(bsdf, surface.wo) : LobeSet(0);
        separable_ = LobeMask(LobeFlags::All, separable);
        const LobeMask others(LobeFlags::All, LobeSet(~separable));
        const bool mixed = bsdf.hasWithin(others);
        answered_ = trainsHere_ = false;
        if (separable != 0) askCache(path, bsdf.viewFactor(surface.wo, separable), mixed);
        if (!shown_ && trainings_.empty()) return {};

        // A path that trains is sampled through all lobes, another one through those that are still to be shown, as
        // often as the path tracer would choose them.
        const bool othersAlone = answered_ && trainings_.empty();
        divided_ = mixed && !othersAlone && (answered_ || trainsHere_);
        if (!othersAlone) return LobeFlags::All;
        const float own = maxComponent(bsdf.albedo(surface.wo, others)), all = maxComponent(bsdf.albedo(surface.wo));
        const float survival = std::clamp(own / std::max(all, 1e-8f), kLeastSurvival, 1.f);
        if (random_.nextFloat() >= survival) return {};
        path.throughput *= 1 / survival;
        return others;
    }
    void lit(const LitVertex& vertex) {
        if (isBlack(vertex.light)) return;
        const Rgb part = separableShare(vertex.wi);
        if (shown_)
            add(vertex.throughput * share_ * (divided_ && answered_ ? vertex.light * (Rgb(1.f) - part) : vertex.light));
        trainings_.add(vertex.light, vertex.depth, maxDepth_, trainsHere_ ? part : Rgb(1.f));
    }
    void scattered(const PathState& path) {
        const bool specular = path.pdf == DirectLighting::kSpecular;
        if (!specular) {
            distance_ = 0;
            pdf_ = path.pdf;
        }
        const Rgb part = specular && (divided_ || trainsHere_) ? Rgb(0.f) : separableShare(path.ray.d);
        if (divided_ && answered_) share_ *= Rgb(1.f) - part;
        trainings_.scatter(path.weight, trainsHere_ ? part : Rgb(1.f));
    }

    Rgb finish() {
        trainings_.deposit(sample_.deposits, walker_.settings().clamp);
        return RadianceVisitor::finish();
    }

  private:
    // Whether the path has light to find beyond its next vertex, for the picture or for deposits.
    bool isWanted(const PathState& path) {
        noteArrival(path);
        if (path.depth >= maxDepth_) shown_ = false;
        return shown_ || trainings_.wantMore(path.depth, maxDepth_);
    }
    // Asks the cache for the light of the separable lobes, and decides whether the path makes a deposit.
    // mixed: whether there are other lobes.
    void askCache(const PathState& path, const Rgb& viewFactor, bool mixed) {
        if (!accepted_) {
            ++sample_.counts.refused;
            return;
        }
        if (!shown_) return;
        ++sample_.counts.asked;
        const Rgb factor = cacheableFactor(viewFactor);
        CacheAnswer answer;
        answered_ = sample_.cache.lookUp(point_, answer);
        if (answered_) {
            ++sample_.counts.answered;
            add(path.throughput * share_ * factor * answer.perFactor);
            shown_ = mixed;
        }
        // Deposits are made where look-ups are, and nowhere else, so that both have the same distribution.
        trainsHere_ =
            random_.nextFloat() < answer.training * sample_.training && trainings_.begin(point_, factor, path.depth);
    }
    // f_separable / f_all for a direction, where one sample of all lobes serves two estimates: the deposit takes this
    // share; the picture takes the rest if the cache answered for the separable lobes.
    Rgb separableShare(const Vec3& wi) const {
        return divided_ ? shareOf(bsdf_->f(at_->wo, wi, separable_), bsdf_->f(at_->wo, wi)) : Rgb(1.f);
    }

    FinalGather::Sample& sample_;
    const int maxDepth_;
    Pcg32 random_;
    Trainings trainings_;
    // The part of the path's throughput that the picture shows. Where the cache has answered for the separable lobes,
    // it is that of the others.
    Rgb share_{1.f};
    bool shown_ = true;  // whether share_ is not zero
    // Since the last non-specular vertex, and of its direction.
    float distance_ = 0, pdf_ = DirectLighting::kSpecular;

    // The present vertex.
    const SurfaceInteraction* at_ = nullptr;
    const Bsdf* bsdf_ = nullptr;
    CachePoint point_{};
    LobeMask separable_ = LobeFlags::None;
    bool mayAsk_ = false, accepted_ = false;
    bool answered_ = false;    // by the cache, for the separable lobes
    bool trainsHere_ = false;  // whether the path makes a deposit here
    bool divided_ = false;     // whether its direction is sampled for the separable lobes and the others together
};

}  // namespace

Rgb FinalGather::radiance(const Ray& ray, Sample& sample) const {
    GatherVisitor visitor(walker_, sample);
    walker_.walk(PathState(ray), sample.sampler, visitor);
    return visitor.finish();
}

}  // namespace drc
