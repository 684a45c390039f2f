#include "scene/scene.h"

namespace drc {
namespace {

Bounds boundsOf(const std::vector<Primitive>& primitives) {
    Bounds bounds;
    for (const Primitive& primitive : primitives) {
        if (primitive.mesh)
            for (const Vec3& p : primitive.mesh->positions) bounds.extend(p);
        else
            bounds.extend(primitive.shape->bounds());
    }
    return bounds;
}

Bounds moved(const Bounds& b, const Transform& t) {
    Bounds result;
    for (int corner = 0; corner < 8; ++corner)
        result.extend(t.point(
            Vec3(corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y, corner & 4 ? b.max.z : b.min.z)));
    return result;
}

Bounds moved(const Bounds& b, const AnimatedTransform& t) {
    if (!t.isAnimated()) return moved(b, t.start());
    // Between two successive times, a rotating point deviates from a straight line by less than a thousandth of its
    // path, even if two half turns are composed. The margin below covers this deviation.
    constexpr int kTimes = 64;
    Bounds result;
    for (int i = 0; i <= kTimes; ++i) result.extend(moved(b, t.at(float(i) / kTimes)));
    const Vec3 margin = (result.max - result.min) * 1e-3f;
    const float most = std::max({margin.x, margin.y, margin.z});
    result.extend(result.min - Vec3(most));
    result.extend(result.max + Vec3(most));
    return result;
}

size_t triangles(const std::vector<Primitive>& primitives) {
    size_t n = 0;
    for (const Primitive& p : primitives) n += p.mesh ? p.mesh->triangleCount() : 0;
    return n;
}

}  // namespace

double Instance::memory() const {
    // Bytes for an instance that stands still, in addition for one that moves, and per step of its motion: measured
    // with thousands of instances and rounded up.
    constexpr double kStill = 1500, kMotion = 2000, kStep = 100;
    return kStill + (objectToWorld.isAnimated() ? kMotion + kStep * objectToWorld.steps() : 0);
}

Bounds Scene::bounds() const {
    std::vector<Bounds> ofObjects;
    for (const ObjectDefinition& object : objects) ofObjects.push_back(boundsOf(object.primitives));
    Bounds b = boundsOf(primitives);
    for (const Instance& i : instances)
        if (const Bounds& object = ofObjects[size_t(i.object)]; !object.empty())
            b.extend(moved(object, i.objectToWorld));
    return b;
}

size_t Scene::triangleCount() const {
    size_t n = triangles(primitives);
    for (const Instance& i : instances) n += triangles(objects[size_t(i.object)].primitives);
    return n;
}

std::unique_ptr<Scene> withoutMedia(const Scene& scene) {
    auto copy = std::make_unique<Scene>();
    copy->primitives = scene.primitives;
    copy->objects = scene.objects;
    copy->instances = scene.instances;
    copy->lights = scene.lights;
    copy->sensor = scene.sensor;
    copy->origin = scene.origin;
    copy->placements = scene.placements;
    copy->files = scene.files;
    const auto remove = [](std::vector<Primitive>& from) {
        for (Primitive& primitive : from) primitive.media = {};
    };
    remove(copy->primitives);
    for (ObjectDefinition& object : copy->objects) remove(object.primitives);
    copy->sensor.medium = nullptr;
    return copy;
}

}  // namespace drc
