#include "math/square_warp.h"

namespace drc {
namespace {

struct Interval {
    int first;
    float t;
};
Interval intervalOf(const std::vector<float>& values, float x) {
    if (values.size() == 1) return {0, 0};
    const auto above = std::upper_bound(values.begin(), values.end(), x);
    const size_t i =
        size_t(std::clamp<std::ptrdiff_t>(above - values.begin() - 1, 0, std::ptrdiff_t(values.size()) - 2));
    return {int(i), std::clamp((x - values[i]) / (values[i + 1] - values[i]), 0.f, 1.f)};
}

// For a density that varies linearly from a to b over [0, 1]: its integral over [0, t], and the t for which this
// integral is x.
float linearIntegral(float a, float b, float t) { return t * (a + 0.5f * t * (b - a)); }
float invertLinear(float a, float b, float x) {
    const float divisor = a + safeSqrt(a * a + 2 * (b - a) * x);
    return divisor > 0 ? std::clamp(2 * x / divisor, 0.f, 1.f) : 0;
}

// The last i in [0, count - 2] with value(i) <= x, for values that ascend from 0.
template <typename F>
int findInterval(int count, float x, const F& value) {
    int low = 0, high = count - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (value(middle) <= x ? low : high) = middle;
    }
    return low;
}

}  // namespace

FamilyWeights FamilyGrid::at(float a, float b) const {
    const Interval i = intervalOf(first_, a), j = intervalOf(second_, b);
    FamilyWeights w;
    for (int k = 0; k < 4; ++k) {
        const bool nextFirst = k & 2, nextSecond = k & 1;
        w.weight[size_t(k)] = (nextFirst ? i.t : 1 - i.t) * (nextSecond ? j.t : 1 - j.t);
        if (w.weight[size_t(k)] > 0)
            w.member[size_t(k)] = (i.first + nextFirst) * int(second_.size()) + j.first + nextSecond;
    }
    return w;
}

SquareGrid::Place SquareGrid::at(const Vec2& p) const {
    const float x = std::clamp(p.x, 0.f, 1.f) * float(width - 1), y = std::clamp(p.y, 0.f, 1.f) * float(height - 1);
    const int ix = std::min(int(x), width - 2), iy = std::min(int(y), height - 2);
    return {ix, iy, x - float(ix), y - float(iy)};
}

SquareWarp::SquareWarp(const SquareGrid& grid, std::vector<float> values, int members)
    : grid_(grid), values_(std::move(values)) {
    const size_t width = size_t(grid.width), height = size_t(grid.height);
    conditional_.resize(values_.size());
    marginal_.resize(size_t(members) * height);
    for (size_t m = 0; m < size_t(members); ++m) {
        float* const v = &values_[m * width * height];
        const auto sumOf = [&](const float* row) {
            double sum = 0;
            for (size_t x = 1; x < width; ++x) sum += 0.5 * (double(row[x - 1]) + row[x]);
            return sum;
        };
        double total = 0;
        for (size_t y = 1; y < height; ++y) total += 0.5 * (sumOf(v + (y - 1) * width) + sumOf(v + y * width));
        if (!(total > 0)) {
            std::fill(v, v + width * height, 1.f);
            total = double((width - 1) * (height - 1));
        }
        for (size_t i = 0; i < width * height; ++i) v[i] = float(v[i] / total);
        double below = 0;
        for (size_t y = 0; y < height; ++y) {
            float* const row = &conditional_[m * width * height + y * width];
            double sum = 0;
            for (size_t x = 0; x < width; ++x) {
                if (x > 0) sum += 0.5 * (double(v[y * width + x - 1]) + v[y * width + x]);
                row[x] = float(sum);
            }
            if (y > 0) below += 0.5 * (double((row - width)[width - 1]) + row[width - 1]);
            marginal_[m * height + y] = float(below);
        }
    }
}

// The tables interpolated between the members of a family.
class SquareWarp::View {
  public:
    View(const SquareWarp& warp, const FamilyWeights& family) : warp_(warp), family_(family) {}
    // Integral over the rows up to row y, and over the whole row y.
    float rowsUpTo(int y) const { return mix(warp_.marginal_, warp_.grid_.height, y); }
    float row(int y) const { return upTo(warp_.grid_.width - 1, y); }
    // Integral over row y up to entry x, and the value of this entry.
    float upTo(int x, int y) const { return entry(warp_.conditional_, x, y); }
    float value(int x, int y) const { return entry(warp_.values_, x, y); }

  private:
    float entry(const std::vector<float>& table, int x, int y) const {
        return mix(table, warp_.grid_.size(), y * warp_.grid_.width + x);
    }
    float mix(const std::vector<float>& table, int stride, int index) const {
        float sum = 0;
        for (size_t k = 0; k < 4; ++k)
            if (family_.weight[k] > 0)
                sum += family_.weight[k] * table[size_t(family_.member[k]) * size_t(stride) + size_t(index)];
        return sum;
    }

    const SquareWarp& warp_;
    const FamilyWeights& family_;
};

SquareWarp::Warped SquareWarp::sample(const Vec2& u, const FamilyWeights& family) const {
    const View view(*this, family);
    const int lastX = grid_.width - 1, lastY = grid_.height - 1;
    const float targetY = u.y * view.rowsUpTo(lastY);
    const int y = findInterval(grid_.height, targetY, [&](int i) { return view.rowsUpTo(i); });
    const float row0 = view.row(y), row1 = view.row(y + 1);
    const float fy = invertLinear(row0, row1, targetY - view.rowsUpTo(y));

    const auto upTo = [&](int x) { return lerp(fy, view.upTo(x, y), view.upTo(x, y + 1)); };
    const auto value = [&](int x) { return lerp(fy, view.value(x, y), view.value(x, y + 1)); };
    const float targetX = u.x * lerp(fy, row0, row1);
    const int x = findInterval(grid_.width, targetX, upTo);
    const float value0 = value(x), value1 = value(x + 1);
    const float fx = invertLinear(value0, value1, targetX - upTo(x));
    return {Vec2((float(x) + fx) / float(lastX), (float(y) + fy) / float(lastY)),
            lerp(fx, value0, value1) * float(lastX * lastY)};
}

SquareWarp::Warped SquareWarp::invert(const Vec2& p, const FamilyWeights& family) const {
    const View view(*this, family);
    const SquareGrid::Place at = grid_.at(p);
    const auto value = [&](int x) { return lerp(at.fy, view.value(x, at.y), view.value(x, at.y + 1)); };
    const float row0 = view.row(at.y), row1 = view.row(at.y + 1), row = lerp(at.fy, row0, row1);
    const float value0 = value(at.x), value1 = value(at.x + 1);
    const float before = lerp(at.fy, view.upTo(at.x, at.y), view.upTo(at.x, at.y + 1));
    const float x = row > 0 ? (before + linearIntegral(value0, value1, at.fx)) / row : 0;
    const float y = (view.rowsUpTo(at.y) + linearIntegral(row0, row1, at.fy)) / view.rowsUpTo(grid_.height - 1);
    return {Vec2(std::min(x, 1.f), std::min(y, 1.f)),
            lerp(at.fx, value0, value1) * float((grid_.width - 1) * (grid_.height - 1))};
}

}  // namespace drc
