// Infinite area light with an environment map (PBR 3e, sections 12.6 and 14.2.4).
#include <numbers>

#include "math/coarse_cells.h"
#include "math/distribution.h"
#include "math/warp.h"
#include "scene/lights/light.h"
#include "scene/lights/turn.h"

namespace drc {
namespace {

// Mean of a linearly interpolated row of texels over the cell of one texel: it weights the texel before, the texel
// itself and the texel after by 1/8, 6/8 and 1/8.
float cellAverage(float before, float here, float after) { return (before + 6 * here + after) / 8; }

class InfiniteLight final : public Light {
  public:
    InfiniteLight(const Transform& lightToWorld, const Rgb& scale, EnvironmentMap map, LightAudience audience)
        : lightToWorld_(lightToWorld), worldToLight_(lightToWorld.inverse()), audience_(audience) {
        if (map.empty()) map = {1, 1, {Rgb(1.f)}};
        width_ = map.width;
        height_ = map.height;
        texels_ = std::move(map.texels);
        for (Rgb& c : texels_) {
            c *= scale;
            c = isFinite(c) ? clampNonNegative(c) : Rgb(0.f);
        }
        const auto unit = [](const Vec3& v) { return std::abs(lengthSquared(v) - 1) < 1e-5f; };
        rigid_ = unit(worldToLight_.x) && unit(worldToLight_.y) && unit(worldToLight_.z) &&
                 std::abs(dot(worldToLight_.x, worldToLight_.y)) + std::abs(dot(worldToLight_.y, worldToLight_.z)) +
                         std::abs(dot(worldToLight_.z, worldToLight_.x)) <
                     1e-5f;
        determinant_ = std::abs(dot(worldToLight_.x, cross(worldToLight_.y, worldToLight_.z)));
        buildDistribution();
    }

    std::optional<LightSample> sample(const Vec3&, const Vec2& u) const override {
        const Sample2D s = distribution_.sample(u);
        // Uniform in solid angle within the cell. A point uniform in (u, v) would have a higher density towards the
        // poles.
        const float h = lerp(s.local.y, oneMinusCos_[s.y], oneMinusCos_[s.y + 1]);
        const SinCos phi = sinCosOfTurn((float(s.x) + s.local.x) / float(distribution_.width()));
        const float sinTheta = safeSqrt(h * (2 - h));
        const Vec3 local(sinTheta * phi.cos, sinTheta * phi.sin, 1 - h);
        LightSample r;
        r.wi = lightToWorld_(local);
        r.pdf = s.pdf * rowDensity_[s.y];
        if (!rigid_) {
            r.wi = normalize(r.wi);
            r.pdf *= stretch(worldToLight_(r.wi));
        }
        r.distance = kInfinity;
        if (!(r.pdf > 0)) return {};
        return r;
    }

    std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere& scene) const override {
        const auto s = sample(scene.center, uOrigin);
        if (!s) return {};
        const Vec3 d = -s->wi;
        const Rgb radiance = escaped(scene.center, s->wi);
        if (isBlack(radiance)) return {};
        return EmittedRay{
            .p = scene.inFront(d, uLeaving), .d = d, .radiance = radiance, .density = {s->pdf, scene.perFacingArea()}};
    }
    EmissionDensity emissionDensity(const EmitterHit&, const Vec3& d, const SceneSphere& scene) const override {
        return {pdfEscaped(scene.center, -d), scene.perFacingArea()};
    }

    Rgb power(float sceneRadius) const override { return mean_ * (kPi * sqr(sceneRadius)); }
    bool isAtInfinity() const override { return true; }
    bool isInfinite() const override { return true; }

    int mapRows() const override { return height_; }
    LightAudience audience() const override { return audience_; }
    Rgb escaped(const Vec3&, const Vec3& wi) const override { return lookup(mapCoordinates(worldToLight_(wi))); }

    float pdfEscaped(const Vec3&, const Vec3& wi) const override {
        const Vec3 w = worldToLight_(wi);
        const Cell cell = cellAt(mapCoordinates(w));
        return distribution_.pdf(cell.column, cell.row) * rowDensity_[cell.row] * stretch(w);
    }

    Vec2 inverse(const Vec3&, const Vec3& wi) const override {
        const Vec3 w = normalize(worldToLight_(wi));
        const Vec2 uv = mapCoordinates(w);
        const Cell cell = cellAt(uv);
        // 1 - cos(theta), computed without cancellation at the upper pole.
        const float sin2 = w.x * w.x + w.y * w.y;
        const float h = w.z > 0 ? sin2 / (1 + w.z) : 1 - w.z;
        const float top = oneMinusCos_[cell.row], bottom = oneMinusCos_[cell.row + 1];
        const Vec2 local(uv.x * float(distribution_.width()) - float(cell.column), (h - top) / (bottom - top));
        return distribution_.inverse(cell.column, cell.row,
                                     Vec2(std::clamp(local.x, 0.f, 1.f), std::clamp(local.y, 0.f, 1.f)));
    }

  private:
    // u = phi / 2 pi in [0,1), v = theta / pi in [0,1].
    static Vec2 mapCoordinates(const Vec3& w) {
        float phi = std::atan2(w.y, w.x);
        if (phi < 0) phi += 2 * kPi;
        // atan2 is more accurate near the poles than acos.
        const float theta = std::atan2(std::sqrt(w.x * w.x + w.y * w.y), w.z);
        return Vec2(std::min(phi * (0.5f * kInvPi), kOneMinusEpsilon), theta * kInvPi);
    }

    // A cell of the sampling distribution.
    struct Cell {
        int column, row;
    };
    Cell cellAt(const Vec2& uv) const {
        const int columns = distribution_.width(), rows = distribution_.height();
        return {std::clamp(int(uv.x * columns), 0, columns - 1), std::clamp(int(uv.y * rows), 0, rows - 1)};
    }

    // Bilinear interpolation.
    Rgb lookup(const Vec2& uv) const {
        // Texel centres are at half-integers. The map repeats in both directions, as in pbrt.
        const float x = uv.x * width_ - 0.5f, y = uv.y * height_ - 0.5f;
        const float x0 = std::floor(x), y0 = std::floor(y);
        const int i = int(x0), j = int(y0);
        return lerp(y - y0, lerp(x - x0, texel(i, j), texel(i + 1, j)),
                    lerp(x - x0, texel(i, j + 1), texel(i + 1, j + 1)));
    }

    const Rgb& texel(int x, int y) const {
        x %= width_;
        y %= height_;
        return texels_[size_t(y < 0 ? y + height_ : y) * width_ + (x < 0 ? x + width_ : x)];
    }

    // Solid angle in light space per solid angle in world space at a direction. w: worldToLight_ of the unit
    // world-space direction, not normalised. The ratio is 1 for rotations, which lightToWorld nearly always is.
    float stretch(const Vec3& w) const {
        if (rigid_) return 1;
        const float l = length(w);
        return determinant_ / (l * l * l);
    }

    void buildDistribution() {
        // The weight of a texel is the integral of the interpolated luminance over its cell, so that no direction with
        // light has zero pdf, and none is sampled far too often.
        TexelIntegrals f{width_, height_, std::vector<float>(texels_.size())};
        std::vector<double> solidAngles;
        double weights = 0;
        double mean[3] = {0, 0, 0};
        std::vector<float> rows(size_t(width_) * 3);
        for (int y = 0; y < height_; ++y) {
            for (int k = 0; k < 3; ++k)
                for (int x = 0; x < width_; ++x)
                    rows[size_t(k) * width_ + x] =
                        cellAverage(luminance(texel(x - 1, y + k - 1)), luminance(texel(x, y + k - 1)),
                                    luminance(texel(x + 1, y + k - 1)));
            const double solidAngle = oneMinusCosDifference(y, height_);
            solidAngles.push_back(solidAngle);
            for (int x = 0; x < width_; ++x) {
                const size_t i = size_t(y) * width_ + x;
                f.values[i] =
                    float(cellAverage(rows[x], rows[size_t(width_) + x], rows[2 * size_t(width_) + x]) * solidAngle);
                for (int c = 0; c < 3; ++c) mean[c] += texels_[i][c] * solidAngle;
            }
            weights += solidAngle * width_;
        }
        mean_ = Rgb(float(mean[0] / weights), float(mean[1] / weights), float(mean[2] / weights));

        const TexelIntegrals cells = sumsOverCells(f, coarsestCell(f, solidAngles));
        const int cellRows = cells.height;
        distribution_ = Distribution2D(cells.values, cells.width, cellRows);
        oneMinusCos_.clear();
        rowDensity_.resize(cellRows);
        for (int row = 0; row <= cellRows; ++row)
            oneMinusCos_.push_back(float(1 - std::cos(std::numbers::pi * row / cellRows)));
        // Factors that convert pdfs over the unit square to pdfs per solid angle.
        for (int row = 0; row < cellRows; ++row)
            rowDensity_[row] = float(1 / (2 * std::numbers::pi * oneMinusCosDifference(row, cellRows) * cellRows));
    }

    // Difference of cos(theta) between the upper and the lower edge of a row of the map or the distribution.
    static double oneMinusCosDifference(int row, int rows) {
        const double half = std::numbers::pi / (2.0 * rows);
        return 2 * std::sin((2 * row + 1) * half) * std::sin(half);
    }

    Turn lightToWorld_, worldToLight_;
    LightAudience audience_;
    int width_ = 1, height_ = 1;
    std::vector<Rgb> texels_;      // multiplied by scale
    Distribution2D distribution_;  // over cells of one or more texels
    // For each row of the distribution:
    std::vector<float> rowDensity_;  // pdf per solid angle / pdf over the unit square
    std::vector<float>
        oneMinusCos_;        // 1 - cos(theta) at the upper edge of each row, and finally at the map's lower edge
    Rgb mean_;               // mean radiance over the sphere
    float determinant_ = 1;  // absolute value of the determinant of worldToLight
    bool rigid_ = false;     // whether worldToLight preserves lengths
};

}  // namespace

LightPtr makeInfiniteLight(const Transform& lightToWorld, const Rgb& scale, EnvironmentMap map,
                           LightAudience audience) {
    return std::make_shared<InfiniteLight>(lightToWorld, scale, std::move(map), audience);
}

}  // namespace drc
