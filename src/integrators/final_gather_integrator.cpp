// Final gather: path tracing with paths that end in radiance cells, one bounce or more after the visible surface.
#include <algorithm>
#include <bit>
#include <cmath>

#include "cells/cell_size.h"
#include "cells/radiance_cells.h"
#include "integrators/sample_planner.h"
#include "integrators/sampled_integrator.h"
#include "transport/final_gather.h"

namespace drc {
namespace {

// The sizes of cells are halved when the picture has had kRefineAt camera samples, and again whenever their number has
// grown by kRefineFactor. Cells then still get four times as many deposits each, so that with the number of samples
// both the size and the noise of cells fall towards zero.
constexpr double kRefineAt = 1 << 26, kRefineFactor = 16;
// A commit of deposits walks over the whole table of cells, which is most of the work of a coarse picture. While the
// camera moves, commits are postponed until each pixel has a sample, if the cells answer at least this share of the
// look-ups, as in a room that they already cover.
constexpr double kMostlyKnown = 2. / 3;
// In small pictures a commit covers several samples of each pixel: about kSamplesPerCommit camera samples in all, but
// at most a quarter of the samples that each pixel has had, because the first ones improve the cells most, and at most
// kMostSamplesPerCommit samples of a pixel.
constexpr double kSamplesPerCommit = 1 << 19, kMostSamplesPerCommit = 4;

class FinalGatherIntegrator final : public SampledIntegrator {
  public:
    explicit FinalGatherIntegrator(const RenderContext& context)
        : SampledIntegrator(context),
          region_(context.sensor.settings.region()),
          gather_(context.tracer.lighting(), context.tracer.settings()) {
        const RenderParams& params = context.params;
        if (!params.cells) return;
        RadianceCellSettings& settings = cellSettings_;
        if (params.carriedCells || params.startCells) {
            if (params.carriedCells)
                cells_.emplace(CarriedCells(*params.carriedCells), settings.capacity);
            else
                cells_.emplace(*params.startCells, settings.capacity);
            refineAt_ *= std::pow(kRefineFactor, cells_->refined());
            plan();
            return;
        }
        if (!(context.distance > 0)) return;
        settings.size = params.cellSize > 0 ? params.cellSize : cellSizeFor(context.distance);
        settings.lightScale = context.sensor.settings.filmScale;
        cells_.emplace(settings);
        plan();
    }

    // Cells live in world space and survive camera moves. Deposits of whole samples are committed first; those of a
    // coarse picture, which a moving camera abandons many times a second, are dropped.
    bool cameraMoved() override {
        if (!cells_) return false;
        if (wholeSamplesWait_) commit();
        cells_->dropCarried();  // it was of another world, one frame earlier
        region_ = context_.sensor.settings.region();
        rows_.clear();
        plan();
        hasMoved_ = true;
        return true;
    }

    PixelSamples samplesOf(int x, int y, uint32_t sample) const override {
        return planner_ ? planner_->samples(x, y) : PixelSamples{sample, 1};
    }

    void samplePassDone(int samples) override {
        if (!cells_) return;
        planner_->update(samples, samples > 0);
        if (isFrozen() || (hasMoved_ && samples == 0 && mostIsKnown())) return;
        // Carried cells are compared with a sample of each pixel, not with the few of a coarse picture.
        if (samples == 0 && cells_->awaitsComparison()) return;
        if (samples > 0 && double(samples) * double(region_.count()) >= refineAt_) {
            cells_->refine();
            refineAt_ *= kRefineFactor;
        }
        if (samples % samplesPerCommit(samples) == 0)
            commit();
        else
            wholeSamplesWait_ = true;
    }

    void focusPassesDone() override {
        if (cells_ && !isFrozen()) commit();
    }

    const RadianceCells* cells() const override { return cells_ ? &*cells_ : nullptr; }

    void endSampling() override {
        cells_.reset();
        planner_.reset();
        rows_ = {};
    }

    // Also saves the deposits that have not been committed yet, as within a pass.
    void saveState(StateWriter& to) const override {
        to.value(uint8_t(cells_.has_value()));
        if (!cells_) return;
        cells_->save(to);
        planner_->save(to);
        to.value(refineAt_);
        for (const Row& row : rows_) {
            to.value(uint64_t(row.deposits.size()));
            for (const CacheDeposit& d : row.deposits) {
                const auto three = [&](const auto& v) {
                    for (int c = 0; c < 3; ++c) to.value(v[c]);
                };
                three(d.at.p), three(d.at.n), three(d.light), three(d.viewFactor);
                to.value(d.at.reach);
            }
        }
    }
    std::function<void()> loadState(StateReader& from) override {
        if (from.value<uint8_t>() == 0) return [this] { cells_.reset(); };
        if (!planner_) plan();
        // Shared, because std::function must be copyable.
        const auto state = std::make_shared<State>(RadianceCells(cellSettings_), *planner_);
        state->cells.load(from);
        state->planner.load(from);
        state->refineAt = from.value<double>();
        for (size_t i = 0; i < rows_.size(); ++i) {
            const auto count = from.value<uint64_t>();
            if (count > from.remaining() / kDepositBytes) from.fail("it ends too early");
            std::vector<CacheDeposit>& deposits = state->deposits.emplace_back();
            deposits.resize(count);
            for (CacheDeposit& d : deposits) {
                const auto three = [&](auto& v) {
                    for (int c = 0; c < 3; ++c) v[c] = from.value<float>();
                };
                three(d.at.p), three(d.at.n), three(d.light), three(d.viewFactor);
                d.at.reach = from.value<float>();
            }
        }
        return [this, state] {
            cells_ = std::move(state->cells);
            *planner_ = std::move(state->planner);
            refineAt_ = state->refineAt;
            for (size_t i = 0; i < rows_.size(); ++i) rows_[i].deposits = std::move(state->deposits[i]);
            wholeSamplesWait_ = std::ranges::any_of(rows_, [](const Row& row) { return !row.deposits.empty(); });
        };
    }

  private:
    Rgb radiance(const Ray& ray, Sampler& sampler, const Place& place, Film&, const SampleParts& parts) override {
        if (!cells_) return context_.tracer.radiance(ray, sampler, parts);
        Row& row = rows_[size_t(place.y - region_.y0)];
        GBufferSample surface;
        FinalGather::Sample sample{
            .sampler = sampler,
            .cache = *cells_,
            .training = training(place),
            .seed = pixelStream(context_.params.seedOfFrame(), kCellStream + place.index, place.x, place.y),
            .deposits = row.deposits,
            .counts = row.counts,
            .parts = {.gBuffer = &surface, .direct = parts.direct}};
        const Rgb value = gather_.radiance(ray, sample);
        const int half = halfOf(pixelStream(context_.params.seedOfFrame(), kHalfStream, place.x, place.y), place.index);
        planner_->add(place.x, place.y, half, luminance(value), surface);
        if (parts.gBuffer) *parts.gBuffer = surface;
        return value;
    }

    // Number of samples of each pixel between two commits, a power of two. samples: the number each pixel has had so
    // far.
    int samplesPerCommit(int samples) const {
        const double wanted =
            std::min({kSamplesPerCommit / double(region_.count()), samples / 4.0, kMostSamplesPerCommit});
        return int(std::bit_floor(unsigned(std::max(1.0, wanted))));
    }

    bool isFrozen() const { return context_.params.freezeCells; }
    // FinalGather::Sample::training.
    float training(const Place& place) const {
        // Cells ask for deposits by at least one path of eight.
        constexpr float kAll = 8;
        if (isFrozen()) return 0;
        return planner_->training(place.x, place.y) * (context_.params.trainCells ? kAll : 1);
    }
    FinalGather::Counts counts() const {
        FinalGather::Counts all;
        for (const Row& row : rows_) all.add(row.counts);
        return all;
    }
    // Whether the cells have answered most look-ups since the last commit.
    bool mostIsKnown() const {
        const FinalGather::Counts all = counts();
        return double(all.answered) >= kMostlyKnown * double(all.asked);
    }

    void commit() {
        wholeSamplesWait_ = false;
        const FinalGather::Counts all = counts();
        std::vector<std::vector<CacheDeposit>*> lists;
        for (Row& row : rows_) {
            row.counts = {};
            lists.push_back(&row.deposits);
        }
        const size_t deposits = cells_->commit(lists);
        if (context_.stats == nullptr) return;
        Stats& stats = *context_.stats;
        stats.add("cells/look-ups/answered", all.answered);
        stats.add("cells/look-ups/refused: the segment is short or the lobe narrow", all.refused);
        stats.add("cells/look-ups/refused: too little is known", all.asked - all.answered);
        stats.add("cells/deposits", int64_t(deposits));
        if (context_.params.carriedCells) stats.set("cells/forgotten", int64_t(cells_->forgotten()));
        stats.set("cells/cells", int64_t(cells_->used()));
        stats.set("cells/bytes", int64_t(cells_->bytes()));
    }

    void plan() {
        rows_.resize(size_t(region_.height()));
        planner_.emplace(region_, context_.sensor.settings.filmScale, uint32_t(context_.params.firstSample));
    }

    static constexpr uint64_t kCellStream = 0x3000000000, kHalfStream = 0x3001;

    // Deposits and counts of one row of pixels since the last commit. One thread at a time works on a row, and rows are
    // committed in their order, whichever threads worked on them.
    struct alignas(64) Row {
        std::vector<CacheDeposit> deposits;
        FinalGather::Counts counts;
    };
    // State read from a file, before it replaces the integrator's own.
    struct State {
        RadianceCells cells;
        SamplePlanner planner;
        double refineAt = 0;
        std::vector<std::vector<CacheDeposit>> deposits;
    };
    static constexpr size_t kDepositBytes = 13 * sizeof(float);

    PixelRegion region_;
    FinalGather gather_;
    RadianceCellSettings cellSettings_;
    std::optional<RadianceCells> cells_;
    std::optional<SamplePlanner> planner_;
    std::vector<Row> rows_;
    double refineAt_ = kRefineAt;
    bool hasMoved_ = false;          // whether the camera has moved
    bool wholeSamplesWait_ = false;  // whether deposits of a sample of every pixel wait for the next commit
};

}  // namespace

std::unique_ptr<Integrator> makeFinalGatherIntegrator(const RenderContext& context) {
    return std::make_unique<FinalGatherIntegrator>(context);
}

}  // namespace drc
