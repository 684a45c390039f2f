// Light sources (PBR 3e, chapter 12). Radiance is linear RGB; directions are unit and point away from the lit point.
#pragma once
#include <memory>
#include <optional>

#include "math/frame.h"
#include "math/transform.h"
#include "math/vec.h"
#include "math/warp.h"
#include "scene/light_image.h"
#include "scene/light_reach.h"
#include "scene/shape.h"
#include "scene/texture.h"
#include "scene/triangle_mesh.h"

namespace drc {

struct LightSample {
    Vec3 wi;
    // Arriving along wi if nothing blocks; for delta lights the irradiance weight I / d^2 etc. Lights at infinity leave
    // it at zero: escaped(wi) has it, and is best asked when it is known that nothing blocks.
    Rgb radiance{0.f};
    float pdf = 0;       // per solid angle; 1 for delta lights
    float distance = 0;  // to the sampled point; infinity for lights at infinity
    bool delta = false;
    Vec3 ng{0.f};  // of the emitter, as its shape orients it; zero: a point, or infinity
};

// The scene as lights at infinity see it.
struct SceneSphere {
    Vec3 center{0.f};
    float radius = 1;
    // Uniform over the disk in front of the sphere, from where light goes in direction d (unit).
    Vec3 inFront(const Vec3& d, const Vec2& u) const {
        const Vec2 disk = sampleConcentricDisk(u);
        return center + (Frame::fromNormal(d).toWorld(Vec3(disk.x, disk.y, 0)) - d) * radius;
    }
    float perFacingArea() const { return 1 / (kPi * radius * radius); }
};

// The densities of where and in which direction light leaves (PBR 3e, section 16.1.2).
struct EmissionDensity {
    float origin = 0;   // per area of the emitter; at infinity, of directions per solid angle; 1 where there is but one
    float leaving = 0;  // of directions per solid angle; at infinity, of points per area that faces the direction
};

// Light as it sets out. From infinity: from a disk in front of the scene's sphere.
struct EmittedRay {
    Vec3 p, d;  // world space; d unit, the way that light goes
    // Of the emitter: as its shape orients it, or zero for a point or infinity; and which triangle of a mesh.
    Vec3 ng{0.f};
    uint32_t triangle = 0;
    Rgb radiance{0.f};  // along d. Of a point: its intensity. Of a distant light: the irradiance on what faces it
    EmissionDensity density;
};

class Light {
  public:
    virtual ~Light() = default;
    virtual std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const = 0;
    // Light that leaves, for paths that start at lights. None: no light for these numbers.
    virtual std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere&) const = 0;
    // Of emit(), where light leaves in direction d from an emitter's point with geometric normal ng.
    virtual EmissionDensity emissionDensity(const Vec3& ng, const Vec3& d, const SceneSphere&) const = 0;
    // Total emitted power, roughly; for choosing among lights. Lights at infinity need the scene's size.
    virtual Rgb power(float sceneRadius) const = 0;
    virtual bool isDelta() const { return false; }
    // Lights at infinity: radiance from direction wi, and the density of sample() there.
    virtual bool isInfinite() const { return false; }
    virtual Rgb escaped(const Vec3&) const { return Rgb(0.f); }
    virtual float pdfEscaped(const Vec3&) const { return 0; }
    // The u in the unit square for which sample() gives direction wi. Of lights at infinity that are not delta lights.
    virtual Vec2 inverse(const Vec3&) const { return Vec2(0, 0); }
    // Point and extent of a light of finite size, for choosing among many; empty for lights at infinity.
    virtual Bounds bounds() const { return {}; }
    // Of lights of finite size; by default equally bright from all sides.
    virtual LightReach reach() const {
        LightReach r;
        r.bounds = bounds();
        r.intensity = luminance(power(0)) / (4 * kPi);
        return r;
    }
};

using LightPtr = std::shared_ptr<const Light>;

// What an integrator knows of a hit on an emitter.
struct EmitterHit {
    Vec3 p{0.f}, ng{0.f};  // world space, ng as the shape orients it
    uint32_t triangle = 0;
    Vec2 uv{0.f};
};

// A surface that emits: one for each emissive mesh or shape.
class AreaLight : public Light {
  public:
    // emit() chooses points uniformly by area, and directions by their cosine.
    EmissionDensity emissionDensity(const Vec3& ng, const Vec3& d, const SceneSphere&) const final;
    // Radiance leaving the hit point towards wo.
    Rgb emitted(const EmitterHit& hit, const Vec3& wo) const {
        return twoSided_ || dot(hit.ng, wo) > 0 ? radiance_ : Rgb(0.f);
    }
    Rgb power(float) const final { return radiance_ * ((twoSided_ ? 2 : 1) * area() * kPi); }
    // Density, per solid angle at `from`, of sample() choosing this hit.
    virtual float pdf(const Vec3& from, const Vec3& wi, const EmitterHit& hit) const = 0;

  protected:
    AreaLight(const Rgb& radiance, bool twoSided) : radiance_(radiance), twoSided_(twoSided) {}
    virtual float area() const = 0;
    // What emit() returns for a point of the emitter.
    std::optional<EmittedRay> leave(const Vec3& p, const Vec3& ng, const Vec2& u, const SceneSphere& scene) const;

    const Rgb radiance_;
    const bool twoSided_;
};

LightPtr makePointLight(const Vec3& position, const Rgb& intensity);
// The three below shine from the origin of their space. Spot: along +z, fading to nothing over the outermost degrees of
// a cone whose half-angle is coneDegrees. With x what the cosine has of the way from the edge to the full intensity,
// the light there is x^4 (Steep: PBR 3e, section 12.3.1) or 3 x^2 - 2 x^3 (Smooth: PBR 4e, section 12.2.1).
enum class SpotEdge { Steep, Smooth };
LightPtr makeSpotLight(const Transform& lightToWorld, const Rgb& intensity, float coneDegrees, float fadeDegrees,
                       SpotEdge edge = SpotEdge::Steep);
// image empty: equally bright everywhere; else it multiplies the intensity, and says what its rows and columns are
// where the lights are written. fovDegrees: of the picture's shorter side.
LightPtr makeGoniometricLight(const Transform& lightToWorld, const Rgb& intensity, LightImage image);
LightPtr makeProjectionLight(const Transform& lightToWorld, const Rgb& intensity, float fovDegrees, LightImage image);
// direction: from the lit points towards the light, world space.
LightPtr makeDistantLight(const Vec3& direction, const Rgb& radiance);

// An environment map in pbrt's lat-long layout: v = theta / pi from +z of the light's space, u = phi / 2 pi; row 0 at
// theta = 0.
using EnvironmentMap = LightImage;
// map empty: constant. scale multiplies the map.
LightPtr makeInfiniteLight(const Transform& lightToWorld, const Rgb& scale, EnvironmentMap map = {});

// Diffuse emitters (pbrt's "diffuse" area light). Radiance leaves the side of the geometric normal, or both.
std::shared_ptr<const AreaLight> makeMeshAreaLight(const TriangleMesh& mesh, const Rgb& radiance, bool twoSided);
std::shared_ptr<const AreaLight> makeShapeAreaLight(ShapePtr shape, const Rgb& radiance, bool twoSided);

}  // namespace drc
