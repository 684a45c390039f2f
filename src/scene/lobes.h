// The list of all lobes. A new one takes a pair of files, a line here and a test.
#pragma once
#include <variant>

#include "scene/coated_conductor.h"
#include "scene/coated_diffuse.h"
#include "scene/disney_clearcoat.h"
#include "scene/disney_diffuse.h"
#include "scene/fourier_bsdf.h"
#include "scene/fresnel_blend.h"
#include "scene/fresnel_specular.h"
#include "scene/hair_scattering.h"
#include "scene/lambert_reflection.h"
#include "scene/lambert_transmission.h"
#include "scene/layered_diffuse.h"
#include "scene/layered_lobe.h"
#include "scene/measured_bsdf.h"
#include "scene/microfacet_dielectric.h"
#include "scene/microfacet_reflection.h"
#include "scene/microfacet_transmission.h"
#include "scene/oren_nayar.h"
#include "scene/rough_diffuse.h"
#include "scene/sheet_transmission.h"
#include "scene/specular_reflection.h"
#include "scene/specular_transmission.h"
#include "scene/thin_dielectric.h"

namespace drc {

using Lobe =
    std::variant<LambertReflection, LambertTransmission, OrenNayar, MicrofacetReflection, MicrofacetTransmission,
                 MicrofacetDielectric, FresnelBlendBase, FresnelBlendCoat, SpecularReflection, SpecularTransmission,
                 FresnelSpecular, DisneyDiffuse, DisneyClearcoat, HairScattering, ThinDielectric, CoatedDiffuse,
                 CoatedConductor, CoatedMirror, LayeredDiffuse, LayeredLobe<MicrofacetReflection>,
                 LayeredLobe<MicrofacetDielectric>, LayeredLobe<SpecularReflection>, LayeredLobe<SpecularTransmission>,
                 LayeredLobe<FresnelSpecular>, LayeredLobe<ThinDielectric>, LayeredLobe<SheetTransmission>, FourierBsdf,
                 MeasuredBsdf, RoughDiffuse>;

}  // namespace drc
