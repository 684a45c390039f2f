#include "generator_pen.h"

#include <algorithm>
#include <array>
#include <functional>

namespace drc::interior {
namespace {

// A smooth grid of (rows + 1) x (columns + 1) vertices, with normals from central differences of the surface function.
void addGrid(Draft& draft, const Placement& frame, int material, int rows, int columns,
             const std::function<Vec3(float, float)>& at) {
    Mesh& m = draft.meshFor(material, true);
    const int first = static_cast<int>(m.p.size());
    constexpr float kStep = 1e-3f;
    for (int r = 0; r <= rows; ++r) {
        for (int c = 0; c <= columns; ++c) {
            const float u = static_cast<float>(c) / static_cast<float>(columns);
            const float v = static_cast<float>(r) / static_cast<float>(rows);
            // At a pole the derivative along u is zero; the normal slightly beside it is nearly the same.
            const float vn = std::clamp(v, 2 * kStep, 1 - 2 * kStep);
            const Vec3 du = at(u + kStep, vn) - at(u - kStep, vn);
            const Vec3 dv = at(u, vn + kStep) - at(u, vn - kStep);
            m.p.push_back(frame.point(at(u, v)));
            m.n.push_back(frame.vector(normalize(cross(normalize(du), normalize(dv)))));
            m.uv.emplace_back(u, v);
        }
    }
    const int stride = columns + 1;
    const auto add = [&](int a, int b, int c) {
        // Degenerate triangles at the poles have no normal and are dropped.
        const size_t n = m.p.size();
        if (std::max({a, b, c}) >= static_cast<int>(n)) return;
        if (lengthSquared(cross(m.p[b] - m.p[a], m.p[c] - m.p[a])) < 1e-16f) return;
        m.indices.insert(m.indices.end(), {a, b, c});
    };
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            const int i = first + r * stride + c;
            add(i, i + 1, i + stride + 1);
            add(i, i + stride + 1, i + stride);
        }
    }
}

// Cosines that should be zero are not exactly so, and a small exponent would amplify them.
float signedPower(float x, float e) { return std::abs(x) < 1e-5f ? 0 : std::copysign(std::pow(std::abs(x), e), x); }

}  // namespace

void Pen::quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int material, bool unitUv) const {
    Mesh& m = draft_->meshFor(material, false);
    const int i = static_cast<int>(m.p.size());
    for (const Vec3& p : {a, b, c, d}) m.p.push_back(frame_.point(p));
    const float w = unitUv ? 1 : length(b - a);
    const float h = unitUv ? 1 : length(d - a);
    m.uv.insert(m.uv.end(), {Vec2(0, 0), Vec2(w, 0), Vec2(w, h), Vec2(0, h)});
    m.indices.insert(m.indices.end(), {i, i + 1, i + 2, i, i + 2, i + 3});
}

void Pen::triangle(const Vec3& a, const Vec3& b, const Vec3& c, int material) const {
    Mesh& m = draft_->meshFor(material, false);
    const int i = static_cast<int>(m.p.size());
    for (const Vec3& p : {a, b, c}) m.p.push_back(frame_.point(p));
    const float w = length(b - a);
    m.uv.insert(m.uv.end(), {Vec2(0, 0), Vec2(w, 0), Vec2(w / 2, length(c - a))});
    m.indices.insert(m.indices.end(), {i, i + 1, i + 2});
}

void Pen::box(const Vec3& l, const Vec3& h, int material) const {
    quad({l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z}, material);
    quad({l.x, h.y, l.z}, {h.x, h.y, l.z}, {h.x, l.y, l.z}, {l.x, l.y, l.z}, material);
    quad({l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z}, material);
    quad({h.x, h.y, l.z}, {l.x, h.y, l.z}, {l.x, h.y, h.z}, {h.x, h.y, h.z}, material);
    quad({h.x, l.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z}, {h.x, l.y, h.z}, material);
    quad({l.x, h.y, l.z}, {l.x, l.y, l.z}, {l.x, l.y, h.z}, {l.x, h.y, h.z}, material);
    solid(l, h);
}

void Pen::bevelledBox(const Vec3& l, const Vec3& h, float bevel, int material) const {
    const float b = std::min({bevel, (h.x - l.x) * 0.4f, (h.y - l.y) * 0.4f, (h.z - l.z) * 0.4f});
    const Vec3 center = (l + h) * 0.5f;
    // A bevelled corner with the signs s: its vertex on the face that is perpendicular to `axis`.
    const auto corner = [&](std::array<int, 3> s, int axis) {
        Vec3 p;
        for (int i = 0; i < 3; ++i) {
            const float inset = i == axis ? 0 : b;
            p[i] = s[i] > 0 ? h[i] - inset : l[i] + inset;
        }
        return p;
    };
    const auto outwardQuad = [&](Vec3 p, Vec3 q, Vec3 r, Vec3 s) {
        const Vec3 n = cross(q - p, r - p);
        if (dot(n, (p + r) * 0.5f - center) > 0) {
            quad(p, q, r, s, material);
        } else {
            quad(s, r, q, p, material);
        }
    };
    for (int a = 0; a < 3; ++a) {
        const int u = (a + 1) % 3;
        const int v = (a + 2) % 3;
        for (int side : {-1, 1}) {
            std::array<int, 3> s{};
            s[a] = side;
            const auto at = [&](int su, int sv) {
                s[u] = su;
                s[v] = sv;
                return corner(s, a);
            };
            outwardQuad(at(-1, -1), at(1, -1), at(1, 1), at(-1, 1));
        }
        // The bevels of the edges parallel to a, between the faces of u and v.
        for (int su : {-1, 1}) {
            for (int sv : {-1, 1}) {
                std::array<int, 3> s{};
                s[u] = su;
                s[v] = sv;
                s[a] = -1;
                const Vec3 p = corner(s, u), q = corner(s, v);
                s[a] = 1;
                outwardQuad(p, q, corner(s, v), corner(s, u));
            }
        }
    }
    for (int c = 0; c < 8; ++c) {
        const std::array<int, 3> s{(c & 1) ? 1 : -1, (c & 2) ? 1 : -1, (c & 4) ? 1 : -1};
        const Vec3 p = corner(s, 0), q = corner(s, 1), r = corner(s, 2);
        if (dot(cross(q - p, r - p), p - center) > 0) {
            triangle(p, q, r, material);
        } else {
            triangle(p, r, q, material);
        }
    }
    solid(l, h);
}

void Pen::lathe(const Vec3& origin, const std::vector<Vec2>& profile, int material, int segments) const {
    Mesh& m = draft_->meshFor(material, true);
    float widest = 0;
    for (const Vec2& q : profile) widest = std::max(widest, q.x);
    // Each segment of the profile has its own two rings of vertices, so that corners of the profile stay sharp unless
    // they are slight.
    const auto spanNormal = [&](size_t i) {
        const Vec2 d = profile[i + 1] - profile[i];
        const float l = std::max(1e-9f, std::sqrt(d.x * d.x + d.y * d.y));
        return Vec2(d.y / l, -d.x / l);
    };
    for (size_t i = 0; i + 1 < profile.size(); ++i) {
        if (lengthSquared(Vec3(profile[i + 1].x - profile[i].x, profile[i + 1].y - profile[i].y, 0)) < 1e-12f) continue;
        const Vec2 n = spanNormal(i);
        const int first = static_cast<int>(m.p.size());
        for (int end = 0; end < 2; ++end) {
            Vec2 ringNormal = n;
            const size_t other = end == 0 ? i - 1 : i + 1;
            if (other + 1 < profile.size()) {
                const Vec2 neighbour = spanNormal(other);
                if (neighbour.x * n.x + neighbour.y * n.y > 0.75f) ringNormal = n + neighbour;
            }
            const Vec2 q = profile[i + static_cast<size_t>(end)];
            for (int s = 0; s <= segments; ++s) {
                const float u = static_cast<float>(s) / static_cast<float>(segments);
                const float phi = 2 * kPi * static_cast<float>(s % segments) / static_cast<float>(segments);
                const float c = std::cos(phi), k = std::sin(phi);
                m.p.push_back(frame_.point(origin + Vec3(q.x * c, q.x * k, q.y)));
                m.n.push_back(frame_.vector(normalize(Vec3(ringNormal.x * c, ringNormal.x * k, ringNormal.y))));
                m.uv.emplace_back(u, q.y);
            }
        }
        const int stride = segments + 1;
        for (int s = 0; s < segments; ++s) {
            const int a = first + s;
            if (profile[i].x > 0) m.indices.insert(m.indices.end(), {a, a + 1, a + stride});
            if (profile[i + 1].x > 0) m.indices.insert(m.indices.end(), {a + 1, a + stride + 1, a + stride});
        }
    }
    // The inscribed box rather than the bounding box, since only volume that is certainly occupied counts as solid.
    const float r = widest * 0.7f;
    solid(origin + Vec3(-r, -r, profile.front().y), origin + Vec3(r, r, std::max(profile.front().y, profile.back().y)));
}

void Pen::cylinder(const Vec3& base, float radius, float height, int material, int segments) const {
    lathe(base, {{0, 0}, {radius, 0}, {radius, height}, {0, height}}, material, segments);
}

void Pen::shade(const Vec3& base, float bottomRadius, float topRadius, float height, int material) const {
    addGrid(*draft_, frame_, material, 2, 28, [&](float u, float v) {
        const float r = bottomRadius + (topRadius - bottomRadius) * v;
        return base + Vec3(r * std::cos(2 * kPi * u), r * std::sin(2 * kPi * u), height * v);
    });
}

void Pen::rod(const Vec3& a, const Vec3& b, float radius, int material) const {
    const Vec3 axis = normalize(b - a);
    const Vec3 side = normalize(cross(axis, std::abs(axis.z) < 0.9f ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
    const Vec3 up = cross(axis, side);
    addGrid(*draft_, frame_, material, 1, 10, [&](float u, float v) {
        return a + (b - a) * v + side * (radius * std::cos(2 * kPi * u)) + up * (radius * std::sin(2 * kPi * u));
    });
}

void Pen::sphere(const Vec3& center, float radius, int material) const {
    draft_->spheres.push_back({frame_.point(center), radius, material});
    const float r = radius * 0.57f;
    solid(center - Vec3(r, r, r), center + Vec3(r, r, r));
}

void Pen::cushion(const Vec3& lo, const Vec3& hi, int material, float exponent) const {
    const Vec3 c = (lo + hi) * 0.5f, h = (hi - lo) * 0.5f;
    addGrid(*draft_, frame_, material, 12, 24, [&](float u, float v) {
        const float theta = kPi * (v - 0.5f), phi = 2 * kPi * u;
        const float r = signedPower(std::cos(theta), exponent);
        return c + Vec3(h.x * r * signedPower(std::cos(phi), exponent), h.y * r * signedPower(std::sin(phi), exponent),
                        h.z * signedPower(std::sin(theta), exponent));
    });
    solid(c - h * 0.8f, c + h * 0.8f);
}

void Pen::curtain(const Vec3& a, const Vec3& b, float height, float foldDepth, int folds, int material) const {
    const Vec3 along = normalize(b - a);
    const Vec3 out(-along.y, along.x, 0);
    addGrid(*draft_, frame_, material, 4, folds * 8, [&](float u, float v) {
        // The folds get deeper towards the hem.
        const float depth = foldDepth * (1 - 0.5f * v) * std::sin(2 * kPi * static_cast<float>(folds) * u);
        return a + (b - a) * u + out * depth - Vec3(0, 0, height * (1 - v));
    });
}

void Pen::shape(const Vec3& at, std::string parameters, int material) const {
    draft_->shapes.push_back({frame_.inner(Placement{at, 1, 0}), material, std::move(parameters)});
}

void Pen::solid(const Vec3& lo, const Vec3& hi) const { draft_->solids.push_back({frame_, lo, hi}); }

void Pen::surface(const Vec3& center, float halfX, float halfY, float clearance) const {
    draft_->surfaces.push_back(
        {frame_.inner(Placement{center, 1, 0}), Vec2(-halfX, -halfY), Vec2(halfX, halfY), clearance});
}

void Pen::quadLight(const Vec3& center, const Vec3& halfU, const Vec3& halfV, int group, int material) const {
    Emitter e;
    e.shape = EmitterShape::Quad;
    e.center = frame_.point(center);
    e.u = frame_.vector(halfU);
    e.v = frame_.vector(halfV);
    e.normal = normalize(cross(e.u, e.v));
    e.group = group;
    e.material = material;
    draft_->emitters.push_back(e);
}

void Pen::diskLight(const Vec3& center, const Vec3& normal, float radius, int group, int material) const {
    Emitter e;
    e.shape = EmitterShape::Disk;
    e.center = frame_.point(center);
    e.normal = normalize(frame_.vector(normal));
    e.radius = radius;
    e.group = group;
    e.material = material;
    draft_->emitters.push_back(e);
}

void Pen::sphereLight(const Vec3& center, float radius, int group, int material) const {
    Emitter e;
    e.shape = EmitterShape::Sphere;
    e.center = frame_.point(center);
    e.radius = radius;
    e.group = group;
    e.material = material;
    draft_->emitters.push_back(e);
}

}  // namespace drc::interior
