// Makes camera rays, for pictures, map sites and training examples alike.
#pragma once
#include "math/sampler.h"
#include "scene/scene.h"

namespace drc {

// The start of every sample of a pixel: film position and camera ray.
struct CameraSample {
    Sampler sampler;  // continues with the path's random numbers
    Vec2 film;        // position, in pixels
    float filterWeight;
    CameraRay camera;  // its weight is 0 where the lens blocks all light
};

// The Sampler stream of a pixel's own random numbers. purpose: a number for each use, so that uses are independent.
inline uint64_t pixelStream(uint64_t seed, uint64_t purpose, int x, int y) {
    return hashCombine(seed, hashCombine(purpose, (uint64_t(uint32_t(y)) << 32) | uint32_t(x)));
}

// The camera ray through a film position. Draws three numbers from the sampler: two for the lens and one for time.
inline CameraRay cameraRay(const Sensor& sensor, const Vec2& film, Sampler& sampler) {
    const Vec2 uLens = sampler.get2D();
    CameraRay camera = sensor.camera->generateRay(film, uLens, sampler.get1D());
    camera.ray.medium = sensor.medium;
    camera.ray.fromCamera = true;
    return camera;
}

// Sample `index` of pixel (x, y). The position on the film is drawn in proportion to the pixel filter.
inline CameraSample cameraSample(const Sensor& sensor, int x, int y, uint64_t stream, uint32_t index) {
    CameraSample s{Sampler(stream, index), Vec2(0.f), 0, {}};
    const FilterSample f = sensor.settings.filter->sample(s.sampler.get2D(), index, stream);
    s.film = Vec2(float(x) + 0.5f + f.offset.x, float(y) + 0.5f + f.offset.y);
    s.filterWeight = f.weight;
    s.camera = cameraRay(sensor, s.film, s.sampler);
    return s;
}

}  // namespace drc
