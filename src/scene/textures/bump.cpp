#include "scene/textures/bump.h"

namespace drc {

Frame bumpFrame(const TextureContext& at, const Frame& shading, const FloatTexture& displacement, const Vec3& dndu,
                const Vec3& dndv) {
    if (displacement.isConstant() && lengthSquared(dndu) == 0 && lengthSquared(dndv) == 0) return shading;
    // On meshes the derivatives lie in the triangle's plane. They are projected to the tangent plane of the smooth
    // surface that the shading normal approximates, so that zero displacement gives exactly the shading normal.
    const Vec3& n = shading.n;
    const Vec3 dpdu = at.dpdu - n * dot(n, at.dpdu);
    const Vec3 dpdv = at.dpdv - n * dot(n, at.dpdv);
    if (!(lengthSquared(cross(dpdu, dpdv)) > 0)) return shading;

    // The step is half the footprint, because details finer than the footprint would only be noise.
    const float delta = at.uvFootprint > 0 ? 0.5f * at.uvFootprint : 0.0005f;
    const auto heightAt = [&](const Vec2& step) {
        TextureContext shifted = at;
        shifted.p = at.p + dpdu * step.x + dpdv * step.y;
        shifted.uv = at.uv + step;
        shifted.n = normalize(at.n + dndu * step.x + dndv * step.y);
        return displacement.eval(shifted);
    };
    const float height = displacement.eval(at);
    const float slopeU = (heightAt(Vec2(delta, 0)) - height) / delta;
    const float slopeV = (heightAt(Vec2(0, delta)) - height) / delta;
    const Vec3 displacedU = dpdu + n * slopeU + dndu * height;
    const Vec3 displacedV = dpdv + n * slopeV + dndv * height;
    const Vec3 normal = cross(displacedU, displacedV);
    const float l2 = lengthSquared(normal);
    if (!(l2 > 0) || !std::isfinite(l2)) return shading;
    return Frame::fromNormalAndTangent(faceForward(normal * (1 / std::sqrt(l2)), n), displacedU);
}

Frame normalMapFrame(const TextureContext& at, const Frame& shading, const RgbTexture& normals) {
    const Rgb color = normals.eval(at);
    const Vec3 local(2 * color.x - 1, 2 * color.y - 1, 2 * color.z - 1);
    if (!(local.z > 0) || !isFinite(color)) return shading;
    const Frame alongU = Frame::fromNormalAndTangent(shading.n, at.dpdu);
    const Vec3 t = dot(alongU.t, at.dpdv) < 0 ? -alongU.t : alongU.t;
    const Vec3 n = normalize(alongU.s * local.x + t * local.y + shading.n * local.z);
    return Frame::fromNormalAndTangent(n, at.dpdu);
}

}  // namespace drc
