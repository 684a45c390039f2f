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
    // A coat of index eta whose two faces both look outwards: the side of the surface does not matter.
    static Fresnel coat(float eta) {
        Fresnel f;
        f.kind_ = Kind::Coat;
        f.etaT_ = eta;
        return f;
    }
    static Fresnel conductor(const Rgb& eta, const Rgb& k) {
        Fresnel f;
        f.kind_ = Kind::Conductor;
        f.eta_ = eta;
        f.k_ = k;
        return f;
    }
    // Burley's blend of a dielectric of index eta, at metallic 0, and Schlick's approximation for a metal, at 1. Only
    // the part `transmissive` of the dielectric has an inside, with total reflection; the rest is alike from both
    // sides.
    static Fresnel metallic(const Rgb& atNormal, float metallic, float eta, float transmissive = 0) {
        Fresnel f;
        f.kind_ = Kind::Metallic;
        f.etaT_ = eta;
        f.eta_ = atNormal;
        f.metallic_ = metallic;
        f.transmissive_ = transmissive;
        return f;
    }

    Rgb eval(float cosThetaI) const {
        switch (kind_) {
            case Kind::Dielectric:
                return Rgb(fresnelDielectric(cosThetaI, etaI_, etaT_));
            case Kind::Coat:
                return Rgb(fresnelDielectric(std::abs(cosThetaI), etaI_, etaT_));
            case Kind::Conductor:
                return fresnelConductor(cosThetaI, eta_, k_);
            case Kind::Metallic:
                return lerp(metallic_, Rgb(metallicsDielectric(cosThetaI)), fresnelSchlick(std::abs(cosThetaI), eta_));
            case Kind::None:
                break;
        }
        return Rgb(1.f);
    }

  private:
    float metallicsDielectric(float cosThetaI) const {
        const float outside = fresnelDielectric(std::abs(cosThetaI), etaI_, etaT_);
        if (cosThetaI >= 0 || transmissive_ == 0) return outside;
        return lerp(transmissive_, outside, fresnelDielectric(cosThetaI, etaI_, etaT_));
    }

    enum class Kind { None, Dielectric, Coat, Conductor, Metallic };
    Kind kind_ = Kind::None;
    float etaI_ = 1, etaT_ = 1;
    float metallic_ = 0, transmissive_ = 0;
    Rgb eta_{1.f}, k_{0.f};  // of a conductor; eta_ is also what a metallic boundary reflects at normal incidence
};

}  // namespace drc
