#include "scene/scene.h"

namespace drc {
namespace {

void extend(Bounds& bounds, const std::vector<Primitive>& primitives, const Transform* t) {
    const auto add = [&](const Vec3& p) { bounds.extend(t ? t->point(p) : p); };
    for (const Primitive& primitive : primitives) {
        if (primitive.mesh) {
            for (const Vec3& p : primitive.mesh->positions) add(p);
        } else {
            const Bounds b = primitive.shape->bounds();
            for (int corner = 0; corner < 8; ++corner)
                add(Vec3(corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y,
                         corner & 4 ? b.max.z : b.min.z));
        }
    }
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

Bounds Scene::bounds() const {
    Bounds b;
    extend(b, primitives, nullptr);
    for (const Instance& i : instances) extend(b, objects[size_t(i.object)].primitives, &i.objectToWorld);
    return b;
}

size_t Scene::triangleCount() const {
    size_t n = triangles(primitives);
    for (const Instance& i : instances) n += triangles(objects[size_t(i.object)].primitives);
    return n;
}

}  // namespace drc
