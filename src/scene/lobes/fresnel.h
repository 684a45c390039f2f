// Fresnel reflectance of smooth boundaries (PBR 3e, section 8.2.1).
#pragma once
#include "math/vec.h"

namespace drc {

// The relative index of refraction between two dielectrics, with the divisions that do not depend on the angle done in
// advance.
class IndexRatio {
  public:
    IndexRatio(float etaI, float etaT) : eta_(etaT / etaI), inverse_(etaI / etaT) {}
    // See fresnelDielectric().
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

// Finds the weight s in Schlick's form F0 + (1 - F0) s of a smooth dielectric's exact reflectance. A dielectric whose
// reflectance at normal incidence is changed, perhaps tinted, keeps the weight s of the unchanged one.
class DielectricBlend {
  public:
    // eta: index of refraction relative to the outside.
    explicit DielectricBlend(float eta)
        : atNormal_(sqr((eta - 1) / (eta + 1))), scale_(atNormal_ < 1 ? 1 / (1 - atNormal_) : 0) {}
    float weight(float reflectance) const { return std::max(0.f, (reflectance - atNormal_) * scale_); }

  private:
    float atNormal_, scale_;
};

// A Fresnel term that is chosen at run time, as a member of a lobe.
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
    // Only the share `transmissive` of the dielectric has an inside, with total internal reflection; the rest reflects
    // alike on both sides.
    static Fresnel metallic(const Rgb& atNormal, float metallic, float eta, float transmissive = 0) {
        Fresnel f;
        f.kind_ = Kind::Metallic;
        f.ratio_ = IndexRatio(1, eta);
        f.eta_ = atNormal;
        f.metallic_ = metallic;
        f.transmissive_ = transmissive;
        return f;
    }

    // A dielectric of index eta with the given reflectance at normal incidence, which may be tinted; towards grazing
    // angles the reflectance rises to 1 as that of the untinted dielectric does. A coat is seen from outside on both
    // sides of the surface; so is a sheet, which reflects off both of its faces.
    enum class Of { Boundary, Coat, Sheet };
    static Fresnel tinted(const Rgb& atNormal, float eta, Of what) {
        Fresnel f;
        f.kind_ = what == Of::Boundary ? Kind::TintedBoundary : what == Of::Coat ? Kind::TintedCoat : Kind::TintedSheet;
        f.ratio_ = IndexRatio(1, eta);
        f.eta_ = atNormal;
        f.blend_ = DielectricBlend(eta);
        return f;
    }
    // Schlick's approximation of a metal, corrected so that it is multiplied by edgeTint at the cosine 1/7, about 82
    // degrees, where real metals differ most from the approximation (Kutz, Hasan and Edmondson, "Novel Aspects of the
    // Adobe Standard Material", 2021).
    static Fresnel metalWithEdge(const Rgb& atNormal, const Rgb& edgeTint) {
        Fresnel f;
        f.kind_ = Kind::MetalWithEdge;
        f.eta_ = atNormal;
        constexpr float kCosine = 1.f / 7, kSine2 = 6.f / 7;  // kSine2: one minus the cosine
        constexpr float kSine6 = kSine2 * kSine2 * kSine2 * kSine2 * kSine2 * kSine2;
        f.k_ = fresnelSchlick(kCosine, atNormal) * (Rgb(1.f) - edgeTint) * (1 / (kCosine * kSine6));
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
            case Kind::TintedCoat:
                return tintedBy(ratio_.reflectance(std::abs(cosThetaI)));
            case Kind::TintedSheet: {
                const Rgb once = tintedBy(ratio_.reflectance(std::abs(cosThetaI)));
                return Rgb(2 * once.x / (1 + once.x), 2 * once.y / (1 + once.y), 2 * once.z / (1 + once.z));
            }
            case Kind::TintedBoundary:
                return tintedBy(ratio_.reflectance(cosThetaI));
            case Kind::MetalWithEdge: {
                const float c = std::min(1.f, std::abs(cosThetaI)), schlick = schlickWeight(c);
                return clampNonNegative(eta_ + (Rgb(1.f) - eta_) * schlick - k_ * (c * (1 - c) * schlick));
            }
            case Kind::None:
                break;
        }
        return Rgb(1.f);
    }
    // The cosine-weighted mean of eval() over the hemisphere outside. Valid for metalWithEdge() only.
    Rgb meanOfMetalWithEdge() const { return eta_ + (Rgb(1.f) - eta_) * (1.f / 21) - k_ * (1.f / 126); }

  private:
    float metallicsDielectric(float cosThetaI) const {
        const float outside = ratio_.reflectance(std::abs(cosThetaI));
        if (cosThetaI >= 0 || transmissive_ == 0) return outside;
        return lerp(transmissive_, outside, ratio_.reflectance(cosThetaI));
    }

    Rgb tintedBy(float reflectance) const { return eta_ + (Rgb(1.f) - eta_) * blend_.weight(reflectance); }

    enum class Kind {
        None,
        Dielectric,
        Coat,
        Conductor,
        Metallic,
        TintedBoundary,
        TintedCoat,
        TintedSheet,
        MetalWithEdge
    };
    Kind kind_ = Kind::None;
    IndexRatio ratio_{1, 1};
    float metallic_ = 0, transmissive_ = 0;
    DielectricBlend blend_{1};
    // Complex index eta_ + i k_ of a conductor. For metallic(), tinted() and metalWithEdge(), eta_ is the reflectance
    // at normal incidence; for metalWithEdge(), k_ c (1 - c)^6 is subtracted from Schlick's approximation at cosine c.
    Rgb eta_{1.f}, k_{0.f};
};

}  // namespace drc
