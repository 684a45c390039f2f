#include "scene/lobes/bent_normal.h"

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

// Sine of the elevation to which a direction is raised. It is less than the view's own elevation above the surface, so
// that a shading normal equal to the geometric one is never bent.
float leastElevation(float viewElevation) { return std::min(kElevationKept, 0.9f * viewElevation); }

}  // namespace

std::optional<Vec3> bentNormal(const Vec3& shading, const Vec3& geometric, const Vec3& wo, KeepAbove what) {
    // Flat surfaces are never bent, even where rounding puts a grazing view below the horizon.
    if (shading == geometric) return {};
    // Both normals, turned to the viewer's side.
    const float side = dot(wo, geometric) < 0 ? -1.f : 1.f;
    const Vec3 n = shading * side, ng = geometric * side;
    const float up = dot(wo, ng), cosine = dot(n, ng), least = leastElevation(up);
    const bool mirrors = what == KeepAbove::MirroredView;
    // Elevation of the view above the shading normal's horizon, or of the mirrored view above the surface.
    const float elevation = mirrors ? 2 * dot(wo, n) * cosine - up : dot(wo, n);
    if (!(up > 0) || (elevation >= least && (cosine > 0 || !mirrors))) return {};

    // In the plane of both normals, the view is (up, across) = r (cos psi, sin psi), with angles measured from ng. A
    // normal at the angle phi has the view at the elevation r cos(phi - psi) above its horizon, and mirrors it to the
    // elevation r cos(2 phi - psi) above the surface. Both are above `least` for phi = 0, and reach it once on the way
    // to n: where phi, or 2 phi for the mirrored view, is psi + acos(least / r). `limit` is the direction at this
    // angle.
    const Vec3 leaning = n - ng * cosine;
    const float l = length(leaning);
    if (!(l > 0)) return {};
    const Vec3 h = leaning * (1 / l);
    const float across = dot(wo, h), r2 = up * up + across * across;
    const float sine = std::sqrt(std::max(0.f, r2 - least * least));  // r sin(acos(least / r))
    const Vec3 limit = ng * ((up * least - across * sine) / r2) + h * ((across * least + up * sine) / r2);
    const Vec3 bent = normalize(mirrors ? ng + limit : limit);
    if (!(dot(bent, ng) > cosine)) return {};  // differs from n by rounding only
    return bent * side;
}

}  // namespace drc
