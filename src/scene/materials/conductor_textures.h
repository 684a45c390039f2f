// A conductor's complex index of refraction at each point of a surface, measured or derived from a reflectance.
#pragma once
#include "scene/lobes/fresnel.h"
#include "scene/materials/material_params.h"

namespace drc {

// Copper's index of refraction: measured spectra, integrated to RGB.
inline const Rgb kCopperEta(0.2004377f, 0.9240334f, 1.1022120f);
inline const Rgb kCopperK(3.9129485f, 2.4528477f, 2.1421880f);

class ConductorTextures {
  public:
    // Null eta and k are copper's. reflectance: the reflectance at normal incidence, in place of eta and k; may be
    // null.
    ConductorTextures(RgbTexturePtr eta, RgbTexturePtr k, RgbTexturePtr reflectance = nullptr)
        : eta_(orConstant(std::move(eta), kCopperEta)),
          k_(orConstant(std::move(k), kCopperK)),
          reflectance_(std::move(reflectance)) {}

    // outside: index of refraction of the medium above the conductor.
    Fresnel at(const TextureContext& point, float outside = 1) const {
        const Rgb eta = reflectance_ ? Rgb(1.f) : eta_->eval(point);
        const Rgb k = reflectance_ ? extinctionOf(reflectance_->eval(point)) : k_->eval(point);
        return Fresnel::conductor(eta * (1 / outside), k * (1 / outside));
    }
    bool areAllConstant() const { return areConstant(eta_, k_, reflectance_); }

  private:
    // The k for which a conductor with eta = 1 in air has this reflectance at normal incidence.
    static Rgb extinctionOf(const Rgb& reflectance) {
        Rgb k;
        for (int c = 0; c < 3; ++c) {
            const float r = std::clamp(reflectance[c], 0.f, 0.9999f);
            k[c] = 2 * std::sqrt(r / (1 - r));
        }
        return k;
    }

    RgbTexturePtr eta_, k_, reflectance_;
};

}  // namespace drc
