#include "pbrt/dialect_factories.h"

#include "pbrt/light_factory_v4.h"
#include "pbrt/material_factory_v4.h"
#include "pbrt/render_settings_v4.h"

namespace drc::pbrt {

const DialectFactories& factoriesOf(Dialect dialect) {
    static constexpr DialectFactories kV3{
        makeMaterial, materialForShape, makeLight, makeAreaLight, makeShape, makeCamera, makeFilter, applyFilm,
        applySampler, applyIntegrator,  "matte",   "image",       "box",     "halton",   "path",     true};
    static constexpr DialectFactories kV4{makeMaterialV4, materialForShapeV4, makeLightV4,  makeAreaLightV4,
                                          makeShapeV4,    makeCameraV4,       makeFilterV4, applyFilmV4,
                                          applySamplerV4, applyIntegratorV4,  "diffuse",    "rgb",
                                          "gaussian",     "zsobol",           "volpath",    false};
    return dialect == Dialect::V3 ? kV3 : kV4;
}

}  // namespace drc::pbrt
