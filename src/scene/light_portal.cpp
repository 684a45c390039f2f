// An environment whose light enters through a portal alone (Bitterli et al., "Portal-Masked Environment Map Sampling",
// EGSR 2015; PBR 4e, section 12.5.3): from a point, only what it sees of the environment through the portal is sampled.
#include "base/parallel.h"
#include "math/distribution.h"
#include "scene/light.h"
#include "scene/portal.h"

namespace drc {
namespace {

// Cells along a side of the tables. A map of the environment has about as many rows over the half turn; a constant one
// needs cells because the solid angle varies.
constexpr int kFewestCells = 64, kMostCells = 1024;
constexpr int kMostPointsPerCell = 8;  // at which the environment is looked up, along a side
// Share of the mean of a cell and its neighbours in its weight, so that no light between the points is left out.
constexpr float kShareOfNeighbours = 1 / 64.f;

class PortalLight final : public Light {
  public:
    PortalLight(LightPtr environment, int rows, const Portal& portal)
        : environment_(std::move(environment)), portal_(portal), side_(std::clamp(rows, kFewestCells, kMostCells)) {
        const std::vector<Cell> cells = cellsOf(std::clamp((rows + side_ - 1) / side_, 2, kMostPointsPerCell));
        std::vector<float> radiance, flux;
        double sum[3] = {};
        for (const Cell& cell : cells) {
            radiance.push_back(cell.luminance);
            flux.push_back(cell.luminance * cell.cosine);
            for (int c = 0; c < 3; ++c) sum[c] += double(cell.flux[c]);
        }
        seen_ = WindowedDistribution2D(spread(radiance), side_, side_);
        entering_ = Distribution2D(spread(flux), side_, side_);
        for (int c = 0; c < 3; ++c) flux_[c] = float(sum[c] * double(portal_.area()) / (double(side_) * side_));
    }

    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const override {
        const auto window = portal_.windowFrom(p);
        if (!window) return {};
        const auto s = seen_.sample(u, *window);
        if (!s) return {};
        const Portal::Direction direction = portal_.directionOf(s->at);
        LightSample r;
        r.wi = direction.w;
        r.pdf = direction.solidAngle > 0 ? s->pdf / direction.solidAngle : 0;
        r.distance = kInfinity;
        if (!(r.pdf > 0)) return {};
        return r;
    }

    std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere& scene) const override {
        const Sample2D s = entering_.sample(uOrigin);
        const float side = float(side_);
        const Portal::Direction from =
            portal_.directionOf(Vec2((float(s.x) + s.local.x) / side, (float(s.y) + s.local.y) / side));
        const Vec3 d = -from.w;
        const Rgb radiance = environment_->escaped(scene.center, from.w);
        const EmissionDensity density = emissionDensity({}, d, scene);
        if (isBlack(radiance) || !(density.origin > 0)) return {};
        // The ray starts before the scene, since something may stand outside, before the portal.
        const Vec3 on = portal_.pointAt(uLeaving);
        const float back = std::max(0.f, dot(on - scene.center, d) + scene.radius);
        return EmittedRay{.p = on - d * back, .d = d, .radiance = radiance, .density = density};
    }
    EmissionDensity emissionDensity(const EmitterHit&, const Vec3& d, const SceneSphere&) const override {
        const auto from = portal_.rectifiedOf(-d);
        if (!from || !(from->solidAngle > 0)) return {};
        return {entering_.pdf(cell(from->at.x), cell(from->at.y)) / from->solidAngle,
                1 / (portal_.area() * from->cosine)};
    }

    // The flux that enters, as that of an area light in the portal.
    Rgb power(float) const override { return flux_; }
    Bounds bounds() const override {
        Bounds box;
        for (const Vec3& corner : portal_.corners()) box.extend(corner);
        return box;
    }
    LightReach reach() const override {
        LightReach r{bounds(), -portal_.outward()};
        r.spread = 0;
        r.intensity = luminance(flux_) * kInvPi;
        return r;
    }

    bool isAtInfinity() const override { return true; }
    bool isInfinite() const override { return true; }
    Rgb escaped(const Vec3& from, const Vec3& wi) const override {
        return portal_.isPassed(from, wi) ? environment_->escaped(from, wi) : Rgb(0.f);
    }
    float pdfEscaped(const Vec3& from, const Vec3& wi) const override {
        const auto window = portal_.windowFrom(from);
        const auto at = portal_.rectifiedOf(wi);
        if (!window || !at || !(at->solidAngle > 0)) return 0;
        return seen_.pdf(at->at, *window) / at->solidAngle;
    }
    Vec2 inverse(const Vec3& from, const Vec3& wi) const override {
        const auto window = portal_.windowFrom(from);
        const auto at = portal_.rectifiedOf(wi);
        return window && at ? seen_.inverse(at->at, *window) : Vec2(0, 0);
    }

  private:
    // Means over a cell of rectified coordinates, per unit of them.
    struct Cell {
        float luminance = 0, cosine = 0;
        Rgb flux{0.f};  // radiance times cosine
    };
    std::vector<Cell> cellsOf(int points) const {
        std::vector<Cell> cells(size_t(side_) * size_t(side_));
        parallelFor(0, side_, 8, [&](int begin, int end) {
            for (int y = begin; y < end; ++y)
                for (int x = 0; x < side_; ++x) {
                    Cell& cell = cells[size_t(y) * size_t(side_) + size_t(x)];
                    for (int j = 0; j < points; ++j)
                        for (int i = 0; i < points; ++i) {
                            const float step = 1 / float(points * side_);
                            const Portal::Direction at = portal_.directionOf(
                                Vec2((float(x * points + i) + 0.5f) * step, (float(y * points + j) + 0.5f) * step));
                            const Rgb light =
                                environment_->escaped(Vec3(0.f), at.w) * (at.solidAngle / float(points * points));
                            cell.luminance += luminance(light);
                            cell.cosine += at.cosine / float(points * points);
                            cell.flux += light * at.cosine;
                        }
                }
        });
        return cells;
    }
    std::vector<float> spread(const std::vector<float>& weights) const {
        std::vector<float> result(weights.size());
        for (int y = 0; y < side_; ++y)
            for (int x = 0; x < side_; ++x) {
                float sum = 0;
                for (int j = -1; j <= 1; ++j)
                    for (int i = -1; i <= 1; ++i)
                        sum += weights[size_t(std::clamp(y + j, 0, side_ - 1)) * size_t(side_) +
                                       size_t(std::clamp(x + i, 0, side_ - 1))];
                const size_t at = size_t(y) * size_t(side_) + size_t(x);
                result[at] = lerp(kShareOfNeighbours, weights[at], sum / 9);
            }
        return result;
    }
    int cell(float x) const { return std::clamp(int(x * float(side_)), 0, side_ - 1); }

    LightPtr environment_;
    Portal portal_;
    int side_;  // of both tables, which are over rectified coordinates
    // What points behind the portal see: radiance.
    WindowedDistribution2D seen_;
    Distribution2D entering_;  // what enters: radiance times cosine
    Rgb flux_{0.f};
};

}  // namespace

LightPtr makePortalLight(LightPtr environment, int rows, const std::array<Vec3, 4>& corners) {
    return std::make_shared<PortalLight>(std::move(environment), rows, Portal(corners));
}

}  // namespace drc
