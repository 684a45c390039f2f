// Compares materials by their behaviour, for tests.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/lobes/bsdf.h"
#include "scene/materials/material.h"

namespace drc::pbrt {

// Values and samples of the material's BSDF for several angles, on both sides and for all lobes. Two different
// materials are very unlikely to share them.
inline std::vector<float> fingerprint(const Material& material) {
    Bsdf bsdf(Frame(), Vec3(0, 0, 1));
    TextureContext at;
    at.uv = Vec2(0.3f, 0.8f);
    at.dpdu = Vec3(1, 0, 0);
    at.dpdv = Vec3(0, 1, 0);
    at.n = Vec3(0, 0, 1);
    material.addLobes(at, Rgb(1.f), bsdf);
    std::vector<float> values;
    const auto add = [&](const Rgb& c) { values.insert(values.end(), {c.x, c.y, c.z}); };
    const Vec3 directions[] = {normalize(Vec3(0.1f, 0.2f, 1)), normalize(Vec3(1, 0.3f, 0.5f)),
                               normalize(Vec3(-0.4f, 1, 0.7f)), normalize(Vec3(-1, 0.2f, -0.6f)),
                               normalize(Vec3(0.2f, -0.3f, -1))};
    for (const Vec3& wo : directions) {
        add(bsdf.albedo(wo));
        for (const Vec3& wi : directions) add(bsdf.f(wo, wi));
        for (const float uLobe : {0.05f, 0.5f, 0.95f}) {
            const auto s = bsdf.sample(wo, uLobe, Vec2(0.4f, 0.7f));
            if (!s) continue;
            values.insert(values.end(), {s->wi.x, s->wi.y, s->wi.z, s->pdf});
            add(s->f);
        }
    }
    return values;
}

inline bool alike(const Material& a, const Material& b) {
    const std::vector<float> x = fingerprint(a), y = fingerprint(b);
    if (x.size() != y.size()) return false;
    for (size_t i = 0; i < x.size(); ++i)
        if (!(std::abs(x[i] - y[i]) <= 1e-4f * std::max({1e-3f, std::abs(x[i]), std::abs(y[i])}))) return false;
    return true;
}

}  // namespace drc::pbrt
