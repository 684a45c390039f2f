// A measured BRDF as a lobe (pbrt-v4's "measured"; PBR 4e, section 9.8). Both sides of the surface reflect, as in pbrt.
#pragma once
#include "scene/lobes/measured_table.h"

namespace drc {

class MeasuredBsdf {
  public:
    // The table must outlive the lobe.
    explicit MeasuredBsdf(const MeasuredTable& table) : table_(&table) {}

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Glossy; }
    float alpha() const { return table_->alpha(); }
    LobeValue evaluate(const Vec3& wo, const Vec3& wi) const {
        return wo.z < 0 ? table_->evaluate(-wo, -wi) : table_->evaluate(wo, wi);
    }
    Rgb f(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).f; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).pdf; }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const { return table_->albedo(wo.z < 0 ? -wo : wo); }

  private:
    const MeasuredTable* table_;
};

}  // namespace drc
