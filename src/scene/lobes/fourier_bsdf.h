// A lobe tabulated as Fourier series: reflection, transmission or both, of an isotropic surface (pbrt-v3's BSDF files;
// PBR 3e, sections 8.6 and 14.1.4).
#pragma once
#include "scene/lobes/fourier_table.h"

namespace drc {

class FourierBsdf {
  public:
    // The table must outlive the lobe, and scatter some light.
    explicit FourierBsdf(const FourierTable& table) : table_(&table) {}

    // A table does not tell diffuse from glossy reflection. The lobe counts as glossy, and as broad if its alpha is
    // large (broadLobes() in lobe.h).
    LobeFlags flags() const {
        return (table_->reflects() ? LobeFlags::Reflection : LobeFlags::None) |
               (table_->transmits() ? LobeFlags::Transmission : LobeFlags::None) | LobeFlags::Glossy;
    }
    float alpha() const { return table_->alpha(); }
    LobeValue evaluate(const Vec3& wo, const Vec3& wi, TransportMode mode) const;
    Rgb f(const Vec3& wo, const Vec3& wi) const { return f(wo, wi, TransportMode::Radiance); }
    Rgb f(const Vec3& wo, const Vec3& wi, TransportMode mode) const { return evaluate(wo, wi, mode).f; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi, TransportMode::Radiance).pdf; }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const { return table_->albedo(wo.z); }

  private:
    // Index on the far side of wo divided by the index on wo's side.
    float relativeEta(const Vec3& wo) const { return wo.z > 0 ? table_->eta() : 1 / table_->eta(); }

    const FourierTable* table_;
};

}  // namespace drc
