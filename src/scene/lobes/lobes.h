// The list of all lobes. A new one needs a pair of files, an entry here and a test.
#pragma once
#include <variant>

#include "scene/lobes/coated_conductor.h"
#include "scene/lobes/coated_diffuse.h"
#include "scene/lobes/disney_clearcoat.h"
#include "scene/lobes/disney_diffuse.h"
#include "scene/lobes/fourier_bsdf.h"
#include "scene/lobes/fresnel_blend.h"
#include "scene/lobes/fresnel_specular.h"
#include "scene/lobes/hair_scattering.h"
#include "scene/lobes/lambert_reflection.h"
#include "scene/lobes/lambert_transmission.h"
#include "scene/lobes/layered_diffuse.h"
#include "scene/lobes/layered_lobe.h"
#include "scene/lobes/measured_bsdf.h"
#include "scene/lobes/microfacet_dielectric.h"
#include "scene/lobes/microfacet_reflection.h"
#include "scene/lobes/microfacet_transmission.h"
#include "scene/lobes/oren_nayar.h"
#include "scene/lobes/rough_diffuse.h"
#include "scene/lobes/sheet_transmission.h"
#include "scene/lobes/specular_reflection.h"
#include "scene/lobes/specular_transmission.h"
#include "scene/lobes/thin_dielectric.h"

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
