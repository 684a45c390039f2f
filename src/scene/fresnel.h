// Fresnel reflectance of smooth boundaries (PBR 3e, section 8.2.1).
#pragma once
#include "math/vec.h"

namespace drc {

// Unpolarised reflectance of a boundary between dielectrics. cosThetaI > 0: the ray comes from the side of index etaI;
// negative: from the other side. 1 at total internal reflection.
float fresnelDielectric(float cosThetaI, float etaI, float etaT);

// Unpolarised reflectance of a conductor of index eta + i k, seen from vacuum. The sign of cosThetaI is ignored.
Rgb fresnelConductor(float cosThetaI, const Rgb& eta, const Rgb& k);

// (1 - cos)^5 of Schlick's approximation.
inline float schlickWeight(float cosTheta) {
    const float m = std::clamp(1 - cosTheta, 0.f, 1.f);
    return (m * m) * (m * m) * m;
}
inline Rgb fresnelSchlick(float cosTheta, const Rgb& atNormal) {
    return atNormal + (Rgb(1.f) - atNormal) * schlickWeight(cosTheta);
}

// The choice among them that a lobe carries.
class Fresnel {
  public:
    // Reflects everything.
    Fresnel() = default;
    static Fresnel none() { return {}; }
    static Fresnel dielectric(float etaI, float etaT) {
        Fresnel f;
        f.kind_ = Kind::Dielectric;
        f.etaI_ = etaI;
        f.etaT_ = etaT;
        return f;
    }
    static Fresnel conductor(const Rgb& eta, const Rgb& k) {
        Fresnel f;
        f.kind_ = Kind::Conductor;
        f.eta_ = eta;
        f.k_ = k;
        return f;
    }

    Rgb eval(float cosThetaI) const {
        switch (kind_) {
            case Kind::Dielectric:
                return Rgb(fresnelDielectric(cosThetaI, etaI_, etaT_));
            case Kind::Conductor:
                return fresnelConductor(cosThetaI, eta_, k_);
            case Kind::None:
                break;
        }
        return Rgb(1.f);
    }

  private:
    enum class Kind { None, Dielectric, Conductor };
    Kind kind_ = Kind::None;
    float etaI_ = 1, etaT_ = 1;
    Rgb eta_{1.f}, k_{0.f};
};

}  // namespace drc
