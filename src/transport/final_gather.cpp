#include "transport/final_gather.h"

#include <array>

namespace drc {
namespace {

// From this maxDepth on, a cache may be asked at every vertex after the first, not only at the second: its answers
// contain light of paths of nearly the full length, hardly more than the rest of the path could collect.
constexpr int kLongPaths = 16;
// Greatest number of deposits of a path. Later vertices have survived so much Russian roulette that their deposits
// would add more noise than information.
constexpr size_t kMaxDeposits = 4;
// Least probability of following the lobes that the cache does not answer for. Their albedo alone cannot decide, since
// lobes only estimate it.
constexpr float kLeastSurvival = 0.05f;

// f_part / f_all for each channel: the share of some lobes in the throughput of a path that was sampled through all
// lobes.
Rgb shareOf(const Rgb& part, const Rgb& all) {
    Rgb share(0.f);
    for (int c = 0; c < 3; ++c) share[c] = all[c] > 0 ? std::min(1.f, part[c] / all[c]) : 0.f;
    return share;
}

// The lobes that a cache may answer for. None if the shading normal was bent for the view, or if the view lies between
// the geometric and the shading horizon: the normal, or the light that samples reach, then depends on the view, and so
// does the light that every lobe scatters.
LobeSet lobesForCache(const Bsdf& bsdf, const Vec3& wo) {
    if (bsdf.bentForView() || dot(wo, bsdf.frame().n) * dot(wo, bsdf.ng()) <= 0) return 0;
    return bsdf.separableLobes();
}

// A vertex that the path makes a deposit for, while the path is still being traced.
struct Training {
    CacheDeposit deposit;
    Rgb throughput{1.f};  // of the path from this vertex to the latest one
    int depth = 0;        // PathState::depth at this vertex
};

// All vertices that a path makes deposits for.
class Trainings {
  public:
    // Adds light that reaches the path's latest vertex, or is scattered there, to all deposits. depth: of the latest
    // vertex. separable: the share of the separable lobes, applied only to the deposit of the latest vertex itself.
    void add(const Rgb& light, int depth, int maxDepth, const Rgb& separable = Rgb(1.f)) {
        for (size_t i = 0; i < count_; ++i) {
            if (!within(i, depth, maxDepth)) continue;
            const Rgb own = at_[i].throughput * light;
            at_[i].deposit.light += at_[i].depth == depth ? own * separable : own;
        }
    }
    // The path continues in a sampled direction. weight: factor on its throughput. separable: the share of the
    // separable lobes, applied only to the newest deposit.
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
    // Deposits contain light of paths that are one vertex shorter than camera paths.
    bool within(size_t i, int depth, int maxDepth) const { return depth - at_[i].depth < maxDepth - 1; }

    std::array<Training, kMaxDeposits> at_;
    size_t count_ = 0;
};

// The path tracer's visitor, with paths that may end in the cache. Besides light for the picture, a path sums the light
// of the deposits that it makes on its way.
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
    void met(const PathState& path, const SurfaceInteraction& surface) {
        RadianceVisitor::met(path, surface);
        distance_ += surface.t;
    }
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

        // A path that makes deposits samples all lobes. Any other path samples only the lobes that the picture still
        // needs, as often as the path tracer would choose them.
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
    // Whether light found from the path's new vertex on is needed, for the picture or for deposits.
    bool isWanted(const PathState& path) {
        noteArrival(path);
        if (path.depth >= maxDepth_) shown_ = false;
        return shown_ || trainings_.wantMore(path.depth, maxDepth_);
    }
    // Asks the cache for the light of the separable lobes, and decides whether the path makes a deposit. mixed: whether
    // the surface has other lobes too.
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
        // Deposits are made only at points of look-ups, so that both have the same distribution.
        trainsHere_ =
            random_.nextFloat() < answer.training * sample_.training && trainings_.begin(point_, factor, path.depth);
    }
    // f_separable / f_all for a direction, where one sample of all lobes serves two estimates: the deposit gets this
    // share of the light, and the picture gets the rest if the cache answered for the separable lobes.
    Rgb separableShare(const Vec3& wi) const {
        return divided_ ? shareOf(bsdf_->f(at_->wo, wi, separable_), bsdf_->f(at_->wo, wi)) : Rgb(1.f);
    }

    FinalGather::Sample& sample_;
    const int maxDepth_;
    Pcg32 random_;
    Trainings trainings_;
    // The share of the path's throughput that the picture shows. Once the cache has answered for the separable lobes,
    // only the share of the other lobes remains.
    Rgb share_{1.f};
    bool shown_ = true;  // whether share_ is not zero
    // Distance since the last non-specular vertex (world units), and pdf of the direction sampled there (per solid
    // angle).
    float distance_ = 0, pdf_ = DirectLighting::kSpecular;

    // The current vertex.
    const SurfaceInteraction* at_ = nullptr;
    const Bsdf* bsdf_ = nullptr;
    CachePoint point_{};
    LobeMask separable_ = LobeFlags::None;
    bool mayAsk_ = false, accepted_ = false;
    bool answered_ = false;    // whether the cache answered for the separable lobes
    bool trainsHere_ = false;  // whether the path makes a deposit here
    bool divided_ = false;     // whether the sampled direction serves the separable lobes and the others together
};

}  // namespace

Rgb FinalGather::radiance(const Ray& ray, Sample& sample) const {
    GatherVisitor visitor(walker_, sample);
    walker_.walk(PathState(ray), sample.sampler, visitor);
    return visitor.finish();
}

}  // namespace drc
