// For tests: measurements of BRDFs that we know, by the definition of their format.
#pragma once
#include "scene/lobes/local_directions.h"
#include "scene/lobes/measured_table.h"
#include "scene/lobes/microfacet.h"

namespace drc::test {

struct MeasuredSizes {
    int theta = 10, phi = 1;  // measured directions
    int normals = 64;         // along a side of the tables of normals
    int light = 32;           // and of the warped ones
    int symmetries = 1;       // of an anisotropic surface: the whole circle, half of it, or a quarter
};

// What would be measured of a surface of these microfacets with the BRDF f. With phi > 1, it is anisotropic.
template <typename F>
MeasuredData measuredDataOf(const F& f, const TrowbridgeReitz& microfacets, const MeasuredSizes& sizes = {}) {
    MeasuredData d;
    const bool isotropic = sizes.phi == 1;
    for (int i = 0; i < sizes.theta; ++i) d.theta.push_back(1.55f * std::sqrt(float(i) / float(sizes.theta - 1)));
    for (int i = 0; i < sizes.phi; ++i)
        d.phi.push_back(isotropic ? 0 : -kPi + 2 * kPi / float(sizes.symmetries) * float(i) / float(sizes.phi - 1));
    d.ndfGrid = d.sigmaGrid = d.vndfGrid = {sizes.normals, sizes.normals};
    d.lightGrid = {sizes.light, sizes.light};
    const auto direction = [](float theta, float phi) {
        return Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    };
    const auto fromSquare = [&](const Vec2& p, float phi) {
        return direction(sqr(p.x) * (kPi / 2), (2 * p.y - 1) * kPi + phi);
    };
    const auto corners = [](const SquareGrid& grid, const auto& visit) {
        for (int y = 0; y < grid.height; ++y)
            for (int x = 0; x < grid.width; ++x)
                visit(Vec2(float(x) / float(grid.width - 1), float(y) / float(grid.height - 1)));
    };
    // The projected area of the microfacets: one over the density of visible normals, divided by D and the cosine.
    const auto area = [&](const Vec3& w) { return 1 / microfacets.g1OverCosine(w); };
    corners(d.ndfGrid, [&](const Vec2& p) { d.ndf.push_back(microfacets.d(fromSquare(p, 0))); });
    corners(d.sigmaGrid, [&](const Vec2& p) { d.sigma.push_back(area(fromSquare(p, 0))); });
    for (const float phi : d.phi)
        for (const float theta : d.theta) {
            const Vec3 wo = direction(theta, phi);
            const float turn = isotropic ? phi : 0;
            corners(d.vndfGrid, [&](const Vec2& p) {
                const Vec3 wm = fromSquare(p, turn);
                const float stretch = 2 * kPi * kPi * p.x * std::sin(sqr(p.x) * (kPi / 2));
                d.vndf.push_back(dot(wo, wm) > 0 ? microfacets.pdf(wo, wm) * stretch : 0);
            });
        }
    const FamilyGrid family(d.phi, d.theta);
    const SquareWarp warp(d.vndfGrid, d.vndf, family.size());
    for (const float phi : d.phi)
        for (const float theta : d.theta) {
            const Vec3 wo = direction(theta, phi);
            corners(d.lightGrid, [&](const Vec2& p) {
                const Vec3 wm = fromSquare(warp.sample(p, family.at(phi, theta)).p, isotropic ? phi : 0);
                const Vec3 wi = reflect(wo, wm);
                const bool visible = dot(wo, wm) > 0 && wi.z > 0 && wo.z > 0;
                d.colors.push_back(visible ? f(wo, wi) * (wi.z * 4 * area(wo) / microfacets.d(wm)) : Rgb(0.f));
                d.luminance.push_back(luminance(d.colors.back()));
            });
        }
    return d;
}

template <typename L>
MeasuredData measuredDataOfLobe(const L& lobe, const TrowbridgeReitz& microfacets, const MeasuredSizes& sizes = {}) {
    return measuredDataOf([&](const Vec3& wo, const Vec3& wi) { return lobe.f(wo, wi); }, microfacets, sizes);
}

}  // namespace drc::test
