// Final gather: path tracing in which paths end in radiance cells, one bounce or more after the surface that is seen.
#include <bit>
#include <cmath>

#include "cache/radiance_cells.h"
#include "integrators/final_gather.h"
#include "render/sampled_integrator.h"

namespace drc {
namespace {

// The finest cells at first, as a share of the median distance that the picture shows: about 16 pixels of a picture
// 1280 pixels wide.
constexpr float kCellSize = 0.0144f;
// The sizes of cells are halved when the picture has had so many camera samples, and again with every kRefineFactor
// times as many. Cells then still get four times as many deposits each, so that with the number of samples both the
// size and the noise of cells fall towards zero.
constexpr double kRefineAt = 1 << 26, kRefineFactor = 16;

class FinalGatherIntegrator final : public SampledIntegrator {
  public:
    explicit FinalGatherIntegrator(const RenderContext& context)
        : SampledIntegrator(context),
          region_(context.scene.settings.region()),
          gather_(context.tracer.lighting(), context.tracer.settings()) {
        if (!context.params.cells || !(context.distance > 0)) return;
        RadianceCellSettings settings;
        // A power of two, so that the frames of an animation have the same cells.
        settings.size = context.params.cellSize > 0 ? context.params.cellSize
                                                    : std::exp2(std::round(std::log2(kCellSize * context.distance)));
        settings.lightScale = context.scene.settings.filmScale;
        cells_.emplace(settings);
        rows_.resize(size_t(region_.height()));
    }

    void samplePassDone(int samples) override {
        if (!cells_) return;
        FinalGather::Counts counts;
        for (Row& row : rows_) {
            counts.add(row.counts);
            row.counts = {};
        }
        if (samples > 0 && double(samples) * double(region_.count()) >= refineAt_) {
            cells_->refine();
            refineAt_ *= kRefineFactor;
        }
        std::vector<std::vector<CacheDeposit>*> lists;
        for (Row& row : rows_) lists.push_back(&row.deposits);
        const size_t deposits = cells_->commit(lists);
        if (context_.stats == nullptr) return;
        Stats& stats = *context_.stats;
        stats.add("cells/look-ups/answered", counts.answered);
        stats.add("cells/look-ups/refused: the segment is short or the lobe narrow", counts.refused);
        stats.add("cells/look-ups/refused: too little is known", counts.asked - counts.answered);
        stats.add("cells/deposits", int64_t(deposits));
        stats.set("cells/cells", int64_t(cells_->used()));
        stats.set("cells/bytes", int64_t(cells_->bytes()));
    }

  private:
    Rgb radiance(const Ray& ray, Sampler& sampler, const Place& place, Film&, GBufferSample* gBuffer) override {
        if (!cells_) return context_.tracer.radiance(ray, sampler, gBuffer);
        Row& row = rows_[size_t(place.y - region_.y0)];
        const uint64_t seed = pixelStream(context_.params.seed, kCellStream + place.index, place.x, place.y);
        return gather_.radiance(ray, sampler, *cells_, seed, row.deposits, row.counts, gBuffer);
    }

    static constexpr uint64_t kCellStream = 0x3000000000;

    // What the samples of a row of pixels have found out in a pass. One thread at a time works on a row, and rows are
    // committed in their order, whichever thread had them.
    struct alignas(64) Row {
        std::vector<CacheDeposit> deposits;
        FinalGather::Counts counts;
    };
    PixelRegion region_;
    FinalGather gather_;
    std::optional<RadianceCells> cells_;
    std::vector<Row> rows_;
    double refineAt_ = kRefineAt;
};

}  // namespace

std::unique_ptr<Integrator> makeFinalGatherIntegrator(const RenderContext& context) {
    return std::make_unique<FinalGatherIntegrator>(context);
}

}  // namespace drc
