#include "scene/lobes/microfacet_albedo.h"

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "scene/lobes/fresnel.h"
#include "scene/lobes/local_directions.h"
#include "scene/lobes/microfacet.h"

namespace drc {
namespace {

constexpr int kCosines = CosineCurve::kNodes;
constexpr int kRoughnesses = 24;       // nodes, evenly spaced in sqrt(alpha) from 0 to 1
constexpr int kIndices = 20;           // see etaOfNode()
constexpr float kLargestRoot = 0.75f;  // square root of the reflectance at normal incidence for an index of 7

// A place between two nodes: the lower node, and the linear weight of the next one.
struct Position {
    int node;
    float share;
};
Position positionIn(int nodes, float x) {
    const float scaled = std::clamp(x, 0.f, 1.f) * float(nodes - 1);
    const int node = std::min(int(scaled), nodes - 2);
    return {node, scaled - float(node)};
}
Position roughnessPosition(int nodes, float alpha) { return positionIn(nodes, std::sqrt(std::max(0.f, alpha))); }
Position indexPosition(int nodes, float eta) {
    return positionIn(nodes, std::sqrt(std::abs(eta - 1) / (eta + 1) / kLargestRoot));
}

float alphaOfNode(int node, int nodes) { return sqr(float(node) / float(nodes - 1)); }
// Nodes are dense at small indices, where the reflectance near the horizon changes fastest.
float etaOfNode(int node, int nodes) {
    const float root = kLargestRoot * sqr(float(node) / float(nodes - 1));
    return (1 + root) / (1 - root);
}
Vec3 directionOfNode(int node) {
    const float c = std::max(1e-4f, CosineCurve::cosineOf(node));  // at the horizon itself nothing is visible
    return Vec3(safeSqrt(1 - c * c), 0, c);
}

// Calls visit(wh, share) for a grid of microfacets visible from wo; the shares add up to 1. The grid covers the unit
// square of random numbers from which visible normals are sampled. Facets far from the mean lie near the square's
// edges, where the grid is dense: its lines are evenly spaced before the warp x^3 (10 - 15 x + 6 x^2), whose slope is
// 30 x^2 (1 - x)^2. Both halves of the first coordinate give facets that mirror each other in the plane of incidence,
// so only one half is visited. perAxis must be even.
template <typename Visit>
void visitFacets(const TrowbridgeReitz& surface, const Vec3& wo, int perAxis, const Visit& visit) {
    const auto line = [&](int i) { return (float(i) + 0.5f) / float(perAxis); };
    const auto warped = [](float x) { return x * x * x * (10 - 15 * x + 6 * x * x); };
    const auto width = [&](float x) { return 30 * sqr(x * (1 - x)) / float(perAxis); };
    for (int i = 0; i < perAxis / 2; ++i)
        for (int j = 0; j < perAxis; ++j) {
            const float x = line(i), y = line(j);
            visit(surface.sample(wo, Vec2(warped(x), warped(y))), 2 * width(x) * width(y));
        }
}
// Masking-shadowing of both directions divided by the masking of wo: the weight of a facet sampled among those visible
// from wo.
float remainingMasking(const TrowbridgeReitz& surface, const Vec3& wo, const Vec3& wi) {
    return 4 * absCosTheta(wi) * surface.visibility(wo, wi) / surface.g1OverCosine(wo);
}

// Tables that are computed on first use, because a scene needs few of them. Safe to use from several threads.
template <typename Table, size_t kCount>
class OnDemand {
  public:
    // make: called at most once for each i.
    template <typename Make>
    const Table& get(size_t i, const Make& make) {
        std::call_once(flags_[i], [&] { tables_[i] = std::make_unique<const Table>(make()); });
        return *tables_[i];
    }

  private:
    std::array<std::once_flag, kCount> flags_;
    std::array<std::unique_ptr<const Table>, kCount> tables_;
};

float blendWeight(int indexNode, float cosTheta) {
    const float eta = etaOfNode(indexNode, kIndices);
    return DielectricBlend(eta).weight(fresnelDielectric(cosTheta, 1, eta));
}

// Albedos of reflecting facets, for one roughness.
struct Reflection {
    CosineCurve albedo;  // of lossless facets
    float meanAlbedo = 1;
    std::array<CosineCurve, kIndices>
        blend;  // per index: albedo of facets with the reflectance DielectricBlend::weight()

    static const Reflection& get(int node) {
        static OnDemand<Reflection, kRoughnesses> tables;
        return tables.get(size_t(node),
                          [&] { return node == 0 ? Reflection() : Reflection(alphaOfNode(node, kRoughnesses)); });
    }

  private:
    // For a smooth surface: light meets all facets at the surface's own cosine.
    Reflection() {
        for (int k = 0; k < kIndices; ++k)
            for (int i = 0; i < kCosines; ++i) blend[size_t(k)][i] = blendWeight(k, CosineCurve::cosineOf(i));
    }
    explicit Reflection(float alpha) {
        constexpr int kPerAxis = 40;
        const TrowbridgeReitz surface(alpha, alpha);
        albedo = CosineCurve(0);
        blend.fill(CosineCurve(0));
        for (int i = 0; i < kCosines; ++i) {
            const Vec3 wo = directionOfNode(i);
            visitFacets(surface, wo, kPerAxis, [&](const Vec3& wh, float share) {
                const float cosine = dot(wo, wh);
                const Vec3 wi = reflect(wo, wh);
                if (cosine <= 0 || wi.z <= 0) return;
                const float weight = share * remainingMasking(surface, wo, wi);
                albedo[i] += weight;
                for (int k = 0; k < kIndices; ++k) blend[size_t(k)][i] += weight * blendWeight(k, cosine);
            });
        }
        meanAlbedo = albedo.mean();
    }
};

// Albedo of a lossless boundary, reflection and refraction together, for one roughness and index. [0]: light arrives on
// the side of the lower index, [1]: on the other.
struct Boundary {
    static constexpr int kRough = 40, kEta = 48;
    CosineCurve albedo[2];
    float meanAlbedo[2] = {1, 1};

    static const Boundary& get(int rough, int eta) {
        static OnDemand<Boundary, kRough * kEta> tables;
        return tables.get(size_t(rough * kEta + eta), [&] {
            return rough == 0 ? Boundary() : Boundary(alphaOfNode(rough, kRough), etaOfNode(eta, kEta));
        });
    }

  private:
    // For a smooth surface: no light is lost, so the albedo is 1.
    Boundary() = default;
    Boundary(float alpha, float index) {
        constexpr int kPerAxis = 32;
        const TrowbridgeReitz surface(alpha, alpha);
        for (const int side : {0, 1}) {
            const float eta = side ? 1 / index : index;
            const IndexRatio boundary(1, eta);
            albedo[side] = CosineCurve(0);
            for (int i = 0; i < kCosines; ++i) {
                const Vec3 wo = directionOfNode(i);
                visitFacets(surface, wo, kPerAxis, [&](const Vec3& wh, float share) {
                    const float cosine = dot(wo, wh);
                    if (cosine <= 0) return;
                    const float reflectance = boundary.reflectance(cosine);
                    if (const Vec3 wi = reflect(wo, wh); wi.z > 0)
                        albedo[side][i] += share * reflectance * remainingMasking(surface, wo, wi);
                    if (Vec3 wt; refract(wo, wh, 1 / eta, wt) && wt.z < 0)
                        albedo[side][i] += share * (1 - reflectance) * remainingMasking(surface, wo, wt);
                });
            }
            meanAlbedo[side] = albedo[side].mean();
        }
    }
};

// The cosine-weighted mean of DielectricBlend::weight() over a smooth surface.
float meanBlend(const Position& index) {
    static const auto means = [] {
        std::array<float, kIndices> m{};
        for (int k = 0; k < kIndices; ++k) {
            CosineCurve smooth;
            for (int i = 0; i < kCosines; ++i) smooth[i] = blendWeight(k, CosineCurve::cosineOf(i));
            m[size_t(k)] = smooth.mean();
        }
        return m;
    }();
    return lerp(index.share, means[size_t(index.node)], means[size_t(index.node) + 1]);
}

// The unabsorbed share of the light scattered more than once, by the geometric series of bounces. single: share that
// leaves the surface after each bounce. reflected: share that each bounce does not absorb.
float leftOfFurtherBounces(float reflected, float single) {
    return reflected * single / (1 - reflected * (1 - single));
}
Rgb leftOfFurtherBounces(const Rgb& reflected, float single) {
    Rgb left;
    for (int c = 0; c < 3; ++c) left[c] = leftOfFurtherBounces(std::clamp(reflected[c], 0.f, 1.f), single);
    return left;
}

}  // namespace

MultipleScattering MultipleScattering::ofReflection(float alpha, const Rgb& meanFresnel) {
    const Position r = roughnessPosition(kRoughnesses, alpha);
    const Reflection &smoother = Reflection::get(r.node), &rougher = Reflection::get(r.node + 1);
    MultipleScattering m;
    m.rows_ = 2;
    for (const int side : {0, 1}) {
        m.albedo_[side][0] = &smoother.albedo;
        m.albedo_[side][1] = &rougher.albedo;
        m.left_[side] = leftOfFurtherBounces(meanFresnel, lerp(r.share, smoother.meanAlbedo, rougher.meanAlbedo));
    }
    m.share_[0] = 1 - r.share;
    m.share_[1] = r.share;
    return m;
}

MultipleScattering MultipleScattering::ofBoundary(float alpha, float eta, const Rgb& transmittance) {
    const Position r = roughnessPosition(Boundary::kRough, alpha);
    const Position k = indexPosition(Boundary::kEta, eta);
    MultipleScattering m;
    m.rows_ = 4;
    float mean[2] = {};
    for (int n = 0; n < 4; ++n) {
        const Boundary& table = Boundary::get(r.node + n / 2, k.node + n % 2);
        m.share_[n] = (n / 2 ? r.share : 1 - r.share) * (n % 2 ? k.share : 1 - k.share);
        for (const int below : {0, 1}) {
            const int side = (eta < 1) != (below == 1);
            m.albedo_[below][n] = &table.albedo[side];
            mean[below] += m.share_[n] * table.meanAlbedo[side];
        }
    }
    for (const int below : {0, 1}) m.left_[below] = leftOfFurtherBounces(transmittance, mean[below]);
    return m;
}

Rgb MultipleScattering::factor(const Vec3& wo) const {
    if (rows_ == 0) return Rgb(1.f);
    const int below = wo.z < 0;
    float albedo = 0;
    for (int k = 0; k < rows_; ++k) albedo += share_[k] * albedo_[below][k]->at(wo.z);
    return Rgb(1.f) + left_[below] * (1 / std::max(0.05f, albedo) - 1);
}

CosineCurve dielectricAlbedo(float alpha, float eta, float atNormal) {
    const Position r = roughnessPosition(kRoughnesses, alpha);
    const Position k = indexPosition(kIndices, eta);
    const Reflection &smoother = Reflection::get(r.node), &rougher = Reflection::get(r.node + 1);
    const float mean = lerp(r.share, smoother.meanAlbedo, rougher.meanAlbedo);
    const float left = leftOfFurtherBounces(lerp(meanBlend(k), atNormal, 1), mean);
    CosineCurve sum;
    for (int i = 0; i < kCosines; ++i) {
        const auto blend = [&](const Reflection& table) {
            return lerp(k.share, table.blend[size_t(k.node)][i], table.blend[size_t(k.node) + 1][i]);
        };
        const float blended = lerp(r.share, blend(smoother), blend(rougher));
        const float lossless = lerp(r.share, smoother.albedo[i], rougher.albedo[i]);
        const float once = atNormal * (lossless - blended) + blended;
        sum[i] = std::min(1.f, once * (1 + left * (1 / lossless - 1)));
    }
    return sum;
}

Rgb meanDielectricFresnel(float eta, const Rgb& atNormal) {
    return atNormal + (Rgb(1.f) - atNormal) * meanBlend(indexPosition(kIndices, eta));
}

float singleScatteringAlbedo(float alpha, float cosTheta) {
    const Position r = roughnessPosition(kRoughnesses, alpha);
    return lerp(r.share, Reflection::get(r.node).albedo.at(cosTheta), Reflection::get(r.node + 1).albedo.at(cosTheta));
}

}  // namespace drc
