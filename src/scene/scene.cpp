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
    // Between two of these times, a rotating point deviates from a straight line by less than a thousandth of its path,
    // even if one half turn is composed with another.
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

PixelRegion RenderSettings::region() const {
    const auto edge = [](int n, float f) { return std::clamp(int(std::ceil(float(n) * f)), 0, n); };
    PixelRegion r{edge(film.width, cropWindow[0]), edge(film.height, cropWindow[2]), edge(film.width, cropWindow[1]),
                  edge(film.height, cropWindow[3])};
    if (pixelBounds) {
        r.x0 = std::max(r.x0, pixelBounds->x0);
        r.y0 = std::max(r.y0, pixelBounds->y0);
        r.x1 = std::min(r.x1, pixelBounds->x1);
        r.y1 = std::min(r.y1, pixelBounds->y1);
    }
    r.x0 = std::min(r.x0, film.width - 1);
    r.y0 = std::min(r.y0, film.height - 1);
    r.x1 = std::max(r.x1, r.x0 + 1);
    r.y1 = std::max(r.y1, r.y0 + 1);
    return r;
}

double Instance::memory() const {
    // Measured with thousands of instances and rounded up, in bytes.
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

bool Scene::removeMedia() {
    if (media.empty()) return false;
    const auto remove = [](std::vector<Primitive>& from) {
        for (Primitive& primitive : from) primitive.media = {};
    };
    remove(primitives);
    for (ObjectDefinition& object : objects) remove(object.primitives);
    cameraMedium = nullptr;
    media.clear();
    return true;
}

size_t Scene::triangleCount() const {
    size_t n = triangles(primitives);
    for (const Instance& i : instances) n += triangles(objects[size_t(i.object)].primitives);
    return n;
}

}  // namespace drc
