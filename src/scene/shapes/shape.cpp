#include "scene/shapes/shape.h"

namespace drc {

ShapeSample Shape::sampleFrom(const Vec3& p, const Vec2& u) const {
    ShapeSample s = sample(u);
    const Vec3 d = s.p - p;
    const float distance2 = lengthSquared(d), cosine = absDot(s.ng, d) / std::sqrt(distance2);
    // dw = dA |cos| / d^2 (PBR 3e, section 5.5.3). The pdf is zero if the surface is seen edge-on or contains p,
    // because no light arrives from it.
    s.pdf = distance2 > 0 && cosine > 0 ? s.pdf * distance2 / cosine : 0;
    if (!std::isfinite(s.pdf)) s.pdf = 0;
    return s;
}

float Shape::pdfFrom(const Vec3& p, const Vec3& wi, const ShapePoint& hit) const {
    const float pdf = lengthSquared(hit.p - p) / (absDot(hit.ng, wi) * area());
    return std::isfinite(pdf) ? pdf : 0;
}

Vec2 Shape::uvSeenFrom(const ShapeSample& at, const Vec3&) const { return at.uv; }

}  // namespace drc
