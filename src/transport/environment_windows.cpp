#include "transport/environment_windows.h"

#include <algorithm>

namespace drc {
namespace {

constexpr float kShareOfWindows = 0.75f;
// Cells along a side of a window's table. A sun is wider than one cell; more cells would take longer to fill.
constexpr int kMostCells = 512;
// Windows share a table if their frames agree: the differences of their s and of their n, as lengths, sum to less than
// this.
constexpr float kSameWay = 1e-4f;

float rest(float u, float begin, float share) { return std::clamp((u - begin) / share, 0.f, kOneMinusEpsilon); }

}  // namespace

EnvironmentWindows::EnvironmentWindows(const Light& environment, const std::vector<Portal>& windows)
    : environment_(environment) {
    std::vector<std::shared_ptr<const RectifiedEnvironment>> tables;
    for (size_t i = 0; i < std::min(windows.size(), kMost); ++i) {
        const auto alike = std::find_if(windows.begin(), windows.begin() + ptrdiff_t(i), [&](const Portal& other) {
            return length(other.frame().s - windows[i].frame().s) + length(other.frame().n - windows[i].frame().n) <
                   kSameWay;
        });
        const auto same = size_t(alike - windows.begin());
        tables.push_back(same < i ? tables[same]
                                  : std::make_shared<const RectifiedEnvironment>(environment, environment.mapRows(),
                                                                                 windows[i], kMostCells));
        windows_.emplace_back(windows[i], tables.back());
        bounds_.set(int(i), LightBound(windows_.back().reach()));
    }
}

EnvironmentWindows::Shares EnvironmentWindows::sharesAt(const Vec3& p) const {
    alignas(32) float weights[kMost];
    bounds_.irradiance(p, weights);
    Shares shares{};
    float sum = 0;
    for (size_t i = 0; i < windows_.size(); ++i) {
        // Windows that face away from the point, or have no finite estimate there, get no share.
        if (std::isfinite(weights[i]) && windows_[i].portal().faces(p)) sum += weights[i];
        shares.begin[i + 1] = sum;
    }
    for (size_t i = 1; i <= windows_.size(); ++i) shares.begin[i] *= sum > 0 ? kShareOfWindows / sum : 0;
    return shares;
}

size_t EnvironmentWindows::passedBy(const Vec3& p, const Vec3& wi, const Shares& shares) const {
    for (size_t i = 0; i < windows_.size(); ++i)
        if (shares.of(i) > 0 && windows_[i].portal().isPassed(p, wi)) return i;
    return windows_.size();
}

std::optional<LightSample> EnvironmentWindows::sample(const Vec3& p, const Vec2& u) const {
    if (windows_.empty()) return environment_.sample(p, u);
    const Shares shares = sharesAt(p);
    const float ofAll = shares.ofAll(count());
    if (u.x >= ofAll) {
        auto s = environment_.sample(p, Vec2(rest(u.x, ofAll, 1 - ofAll), u.y));
        if (!s || passedBy(p, s->wi, shares) < count()) return {};
        s->pdf *= 1 - ofAll;
        return s;
    }
    size_t window = 0;
    while (u.x >= shares.begin[window + 1]) ++window;
    const float share = shares.of(window);
    const auto direction = windows_[window].sample(p, Vec2(rest(u.x, shares.begin[window], share), u.y));
    if (!direction || passedBy(p, direction->wi, shares) != window) return {};
    LightSample s;
    s.wi = direction->wi;
    s.pdf = share * direction->pdf;
    s.distance = kInfinity;
    return s;
}

EnvironmentWindows::Inverse EnvironmentWindows::inverse(const Vec3& from, const Vec3& wi) const {
    if (windows_.empty()) return {environment_.pdfEscaped(from, wi), environment_.inverse(from, wi)};
    const Shares shares = sharesAt(from);
    const size_t window = passedBy(from, wi, shares);
    const float begin = shares.begin[window], share = window == count() ? 1 - begin : shares.of(window);
    Inverse r;
    if (window == count()) {
        r = {environment_.pdfEscaped(from, wi), environment_.inverse(from, wi)};
    } else {
        const PortalDirections::Inverse at = windows_[window].inverse(from, wi);
        r = {at.pdf, at.u};
    }
    return {r.pdf * share, Vec2(std::min(begin + r.u.x * share, kOneMinusEpsilon), r.u.y)};
}

}  // namespace drc
