#include "scene/lobes/bent_normal.h"

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

// Sine of the elevation that is kept. Views that are lower above the surface keep nearly their own, so that a shading
// normal that is the geometric one is never bent.
float leastElevation(float viewElevation) { return std::min(kElevationKept, 0.9f * viewElevation); }

}  // namespace

std::optional<Vec3> bentNormal(const Vec3& shading, const Vec3& geometric, const Vec3& wo, KeepAbove what) {
    // Flat surfaces, whatever rounding does to the views along them.
    if (shading == geometric) return {};
    // On the viewer's side.
    const float side = dot(wo, geometric) < 0 ? -1.f : 1.f;
    const Vec3 n = shading * side, ng = geometric * side;
    const float up = dot(wo, ng), cosine = dot(n, ng), least = leastElevation(up);
    const bool mirrors = what == KeepAbove::MirroredView;
    // Elevation of the view above the shading normal's horizon, or of the mirrored view above the surface.
    const float elevation = mirrors ? 2 * dot(wo, n) * cosine - up : dot(wo, n);
    if (!(up > 0) || (elevation >= least && (cosine > 0 || !mirrors))) return {};

    // Let (up, across) be the view in the plane of both normals, with the polar coordinates r and psi from ng. For a
    // normal at the angle phi from ng, its elevation is r cos(phi - psi), and that of the mirrored view is
    // r cos(2 phi - psi). Both are above the limit at ng, and pass it once on the way to n: at psi + acos(least / r).
    const Vec3 leaning = n - ng * cosine;
    const float l = length(leaning);
    if (!(l > 0)) return {};
    const Vec3 h = leaning * (1 / l);
    const float across = dot(wo, h), r2 = up * up + across * across;
    const float sine = std::sqrt(std::max(0.f, r2 - least * least));  // of that arc cosine, times r
    const Vec3 limit = ng * ((up * least - across * sine) / r2) + h * ((across * least + up * sine) / r2);
    const Vec3 bent = normalize(mirrors ? ng + limit : limit);
    if (!(dot(bent, ng) > cosine)) return {};  // because of rounding
    return bent * side;
}

}  // namespace drc
