// Fresnel reflectance of smooth boundaries (PBR 3e, section 8.2.1).
#pragma once
#include "math/vec.h"

namespace drc {

// The relative index of refraction between two dielectrics, with the divisions that do not depend on the angle done in
// advance.
class IndexRatio {
  public:
    IndexRatio(float etaI, float etaT) : eta_(etaT / etaI), inverse_(etaI / etaT) {}
    // As fresnelDielectric().
    float reflectance(float cosThetaI) const {
        const bool inside = cosThetaI <= 0;
        const float eta = inside ? inverse_ : eta_, inverse = inside ? eta_ : inverse_;
        const float cosI = std::min(std::abs(cosThetaI), 1.f);
        const float cos2T = 1 - (1 - cosI * cosI) * (inverse * inverse);
        if (cos2T <= 0) return 1;
        const float cosT = std::sqrt(cos2T);
        const float parallel = (eta * cosI - cosT) / (eta * cosI + cosT);
        const float perpendicular = (cosI - eta * cosT) / (cosI + eta * cosT);
        return 0.5f * (parallel * parallel + perpendicular * perpendicular);
    }

  private:
    float eta_, inverse_;  // etaT / etaI and etaI / etaT
};

// Unpolarised reflectance of the boundary between two dielectrics. cosThetaI > 0: the ray is on the side with index
// etaI; negative: on the other side. 1 for total internal reflection.
inline float fresnelDielectric(float cosThetaI, float etaI, float etaT) {
    return IndexRatio(etaI, etaT).reflectance(cosThetaI);
}

// Unpolarised reflectance of a conductor with the index eta + i k in vacuum. The sign of cosThetaI is ignored.
Rgb fresnelConductor(float cosThetaI, const Rgb& eta, const Rgb& k);

// The factor (1 - cos)^5 of Schlick's approximation.
inline float schlickWeight(float cosTheta) {
    const float m = std::clamp(1 - cosTheta, 0.f, 1.f);
    return (m * m) * (m * m) * m;
}
inline Rgb fresnelSchlick(float cosTheta, const Rgb& atNormal) {
    return atNormal + (Rgb(1.f) - atNormal) * schlickWeight(cosTheta);
}

// One of the Fresnel terms above, as a member of a lobe.
class Fresnel {
  public:
    // A reflectance of 1 at all angles.
    Fresnel() = default;
    static Fresnel none() { return {}; }
    static Fresnel dielectric(float etaI, float etaT) {
        Fresnel f;
        f.kind_ = Kind::Dielectric;
        f.ratio_ = IndexRatio(etaI, etaT);
        return f;
    }
    // A dielectric coat of index eta that is seen from outside on both sides of the surface.
    static Fresnel coat(float eta) {
        Fresnel f;
        f.kind_ = Kind::Coat;
        f.ratio_ = IndexRatio(1, eta);
        return f;
    }
    static Fresnel conductor(const Rgb& eta, const Rgb& k) {
        Fresnel f;
        f.kind_ = Kind::Conductor;
        f.eta_ = eta;
        f.k_ = k;
        return f;
    }
    // Burley's blend of a dielectric of index eta (metallic = 0) and Schlick's approximation of a metal (metallic = 1).
    // Only the share `transmissive` of the dielectric has an inside, with total internal reflection; the rest is the
    // same from both sides.
    static Fresnel metallic(const Rgb& atNormal, float metallic, float eta, float transmissive = 0) {
        Fresnel f;
        f.kind_ = Kind::Metallic;
        f.ratio_ = IndexRatio(1, eta);
        f.eta_ = atNormal;
        f.metallic_ = metallic;
        f.transmissive_ = transmissive;
        return f;
    }

    Rgb eval(float cosThetaI) const {
        switch (kind_) {
            case Kind::Dielectric:
                return Rgb(ratio_.reflectance(cosThetaI));
            case Kind::Coat:
                return Rgb(ratio_.reflectance(std::abs(cosThetaI)));
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
        const float outside = ratio_.reflectance(std::abs(cosThetaI));
        if (cosThetaI >= 0 || transmissive_ == 0) return outside;
        return lerp(transmissive_, outside, ratio_.reflectance(cosThetaI));
    }

    enum class Kind { None, Dielectric, Coat, Conductor, Metallic };
    Kind kind_ = Kind::None;
    IndexRatio ratio_{1, 1};
    float metallic_ = 0, transmissive_ = 0;
    Rgb eta_{1.f}, k_{0.f};  // of a conductor; for metallic(), eta_ is the metal's reflectance at normal incidence
};

}  // namespace drc
