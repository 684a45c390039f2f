#include "pbrt/dialect_factories.h"

#include "pbrt/light_factory_v4.h"
#include "pbrt/material_factory_v4.h"
#include "pbrt/render_settings_v4.h"

namespace drc::pbrt {

const DialectFactories& factoriesOf(Dialect dialect) {
    static constexpr DialectFactories kV3{.material = makeMaterial,
                                          .materialOfShape = materialForShape,
                                          .light = makeLight,
                                          .areaLight = makeAreaLight,
                                          .shape = makeShape,
                                          .camera = makeCamera,
                                          .filter = makeFilter,
                                          .film = applyFilm,
                                          .sampler = applySampler,
                                          .integrator = applyIntegrator,
                                          .defaultMaterial = "matte",
                                          .defaultFilm = "image",
                                          .defaultFilter = "box",
                                          .defaultSampler = "halton",
                                          .defaultIntegrator = "path",
                                          .needsWorldEnd = true};
    static constexpr DialectFactories kV4{.material = makeMaterialV4,
                                          .materialOfShape = materialForShapeV4,
                                          .light = makeLightV4,
                                          .areaLight = makeAreaLightV4,
                                          .shape = makeShapeV4,
                                          .camera = makeCameraV4,
                                          .filter = makeFilterV4,
                                          .film = applyFilmV4,
                                          .sampler = applySamplerV4,
                                          .integrator = applyIntegratorV4,
                                          .defaultMaterial = "diffuse",
                                          .defaultFilm = "rgb",
                                          .defaultFilter = "gaussian",
                                          .defaultSampler = "zsobol",
                                          .defaultIntegrator = "volpath",
                                          .needsWorldEnd = false};
    return dialect == Dialect::V3 ? kV3 : kV4;
}

}  // namespace drc::pbrt
