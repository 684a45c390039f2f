// Maps a point on a surface to texture coordinates, with their derivatives over the footprint (PBR 3e, section 10.2).
#pragma once
#include "math/transform.h"
#include "scene/textures/texture.h"

namespace drc {

// 2D texture coordinates, and their changes along the two axes of the footprint.
struct PlanePoint {
    Vec2 st;
    Vec2 dstdx, dstdy;
};

// pbrt's "uv" mapping: (s, t) = (u * uScale + uDelta, v * vScale + vDelta).
struct UvMapping {
    float uScale = 1, vScale = 1;
    float uDelta = 0, vDelta = 0;
};

class Mapping2D {
  public:
    Mapping2D(const UvMapping& uv = {}) : uv_(uv) {}  // implicit, since nearly every texture uses it
    // Spherical coordinates around the texture's z axis: s is the polar angle divided by pi, t the azimuth divided by 2
    // pi.
    static Mapping2D spherical(const Transform& worldToTexture);
    // Cylindrical coordinates around the texture's z axis: s is the azimuth divided by 2 pi, starting at -x; t is the z
    // component of the unit direction from the texture's origin.
    static Mapping2D cylindrical(const Transform& worldToTexture);
    // s and t are dot products of the world-space position with vs and vt, plus delta.
    static Mapping2D planar(const Vec3& vs, const Vec3& vt, const Vec2& delta);

    PlanePoint at(const TextureContext& context) const;

  private:
    enum class Kind { Uv, Spherical, Cylindrical, Planar };
    PlanePoint sphericalPoint(const TextureContext& context) const;
    PlanePoint cylindricalPoint(const TextureContext& context) const;
    PlanePoint planarPoint(const TextureContext& context) const;

    Kind kind_ = Kind::Uv;
    UvMapping uv_;
    Transform worldToTexture_;
    Vec3 vs_{0.f}, vt_{0.f};
};

// Position in the space of a solid texture, and its changes along the two axes of the footprint.
struct SolidPoint {
    Vec3 p;
    Vec3 dpdx, dpdy;
};

// The identity mapping of pbrt's solid textures: the position, transformed to texture space.
class Mapping3D {
  public:
    explicit Mapping3D(const Transform& worldToTexture = {}) : worldToTexture_(worldToTexture) {}
    SolidPoint at(const TextureContext& context) const;

  private:
    Transform worldToTexture_;
};

}  // namespace drc
