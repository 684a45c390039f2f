#include "generator_draft.h"

#include <algorithm>

namespace drc::interior {

bool OrientedBox::contains(const Vec3& p, float margin) const {
    const Vec3 q = frame.toLocal(p);
    return q.x > lo.x - margin && q.x < hi.x + margin && q.y > lo.y - margin && q.y < hi.y + margin &&
           q.z > lo.z - margin && q.z < hi.z + margin;
}

float OrientedBox::hit(const Vec3& origin, const Vec3& direction) const {
    const Vec3 o = frame.toLocal(origin);
    const Vec3 d = frame.toLocal(frame.origin + direction);
    float near = 0;
    float far = kInfinity;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(d[i]) < 1e-9f) {
            if (o[i] < lo[i] || o[i] > hi[i]) return kInfinity;
            continue;
        }
        const float a = (lo[i] - o[i]) / d[i];
        const float b = (hi[i] - o[i]) / d[i];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return near <= far ? near : kInfinity;
}

namespace {
template <typename Pick>
Vec3 cornerwise(const OrientedBox& b, Pick pick) {
    Vec3 r = b.frame.point(b.lo);
    for (int c = 1; c < 8; ++c) {
        const Vec3 p = b.frame.point({(c & 1) ? b.hi.x : b.lo.x, (c & 2) ? b.hi.y : b.lo.y, (c & 4) ? b.hi.z : b.lo.z});
        for (int i = 0; i < 3; ++i) r[i] = pick(r[i], p[i]);
    }
    return r;
}
}  // namespace

Vec3 OrientedBox::worldLo() const {
    return cornerwise(*this, [](float a, float b) { return std::min(a, b); });
}
Vec3 OrientedBox::worldHi() const {
    return cornerwise(*this, [](float a, float b) { return std::max(a, b); });
}

float Emitter::area() const {
    switch (shape) {
        case EmitterShape::Quad:
            return 4 * length(cross(u, v));
        case EmitterShape::Sphere:
            return 4 * kPi * radius * radius;
        case EmitterShape::Disk:
            return kPi * radius * radius;
    }
    return 0;
}

Mesh& Draft::meshFor(int material, bool smooth) {
    const auto [it, isNew] = meshIndex_.try_emplace({material, smooth}, meshes.size());
    if (isNew) {
        meshes.emplace_back();
        meshes.back().material = material;
        meshes.back().smooth = smooth;
    }
    return meshes[it->second];
}

size_t Draft::triangleCount() const {
    size_t count = 0;
    for (const Mesh& m : meshes) count += m.indices.size() / 3;
    for (const Emitter& e : emitters) count += e.shape == EmitterShape::Quad ? 2 : 0;
    return count;
}

bool Draft::inFreeSpace(const Vec3& p) const {
    const auto holds = [&](const OrientedBox& b) { return b.contains(p); };
    return std::any_of(freeVolumes.begin(), freeVolumes.end(), holds) &&
           std::none_of(solids.begin(), solids.end(), holds);
}

float Draft::flux() const {
    float sum = average(sky) + average(sun);
    for (const Emitter& e : emitters) sum += kPi * e.area() * average(e.radiance);
    for (const Point& p : points) sum += 4 * kPi * average(p.intensity);
    return sum;
}

}  // namespace drc::interior
