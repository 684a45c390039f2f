// The factory functions of each dialect, which SceneBuilder calls to create the things that a file describes.
#pragma once
#include "pbrt/camera_factory.h"
#include "pbrt/dialect.h"
#include "pbrt/filter_factory.h"
#include "pbrt/light_factory.h"
#include "pbrt/material_factory.h"
#include "pbrt/render_settings.h"
#include "pbrt/shape_factory.h"

namespace drc::pbrt {

struct DialectFactories {
    decltype(&makeMaterial) material;
    decltype(&materialForShape) materialOfShape;
    decltype(&makeLight) light;
    decltype(&makeAreaLight) areaLight;
    decltype(&makeShape) shape;
    decltype(&makeCamera) camera;
    decltype(&makeFilter) filter;
    decltype(&applyFilm) film;
    decltype(&applySampler) sampler;
    decltype(&applyIntegrator) integrator;
    // Types to use if the file contains no such directive.
    const char *defaultMaterial, *defaultFilm, *defaultFilter, *defaultSampler, *defaultIntegrator;
    bool needsWorldEnd;
};
const DialectFactories& factoriesOf(Dialect dialect);

}  // namespace drc::pbrt
