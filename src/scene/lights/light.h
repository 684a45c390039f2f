// Light sources (PBR 3e, chapter 12). Radiance is linear RGB. Directions are unit and point away from the lit point.
#pragma once
#include <array>
#include <memory>
#include <optional>

#include "math/frame.h"
#include "math/transform.h"
#include "math/vec.h"
#include "math/warp.h"
#include "scene/lights/emission.h"
#include "scene/lights/light_image.h"
#include "scene/lights/light_reach.h"
#include "scene/lights/spot_falloff.h"
#include "scene/shapes/shape.h"
#include "scene/shapes/triangle_mesh.h"
#include "scene/textures/texture.h"

namespace drc {

// The description of a point on an emitter.
struct EmitterHit {
    Vec3 p{0.f}, ng{0.f};  // world space; ng as the shape orients it
    uint32_t triangle = 0;
    Vec2 uv{0.f};
};

struct LightSample {
    Vec3 wi;
    // Radiance arriving along wi if unoccluded; for delta lights an irradiance, such as I / d^2. Lights at infinity set
    // it to zero: evaluate escaped(p, wi) instead, preferably after the visibility test.
    Rgb radiance{0.f};
    float pdf = 0;       // per solid angle; 1 for delta lights
    float distance = 0;  // to the sampled point; infinite for lights at infinity
    bool delta = false;
    Vec3 ng{0.f};  // geometric normal of the emitter, as its shape orients it; zero for points and lights at infinity
    // For area lights, as in EmitterHit.
    uint32_t triangle = 0;
    Vec2 uv{0.f};
};

// The bounding sphere of the scene, which lights at infinity need.
struct SceneSphere {
    Vec3 center{0.f};
    float radius = 1;
    // Origin of a ray that a light at infinity emits in direction d (unit): uniformly distributed on the disk that
    // touches the sphere and is perpendicular to d.
    Vec3 inFront(const Vec3& d, const Vec2& u) const {
        const Vec2 disk = sampleConcentricDisk(u);
        return center + (Frame::fromNormal(d).toWorld(Vec3(disk.x, disk.y, 0)) - d) * radius;
    }
    float perFacingArea() const { return 1 / (kPi * radius * radius); }
};

// Pdfs of the two choices of emit() (PBR 3e, section 16.1.2): a point, then a direction; for lights at infinity ("at
// infinity" below), a direction, then a point.
struct EmissionDensity {
    float origin = 0;   // per area of the emitter; at infinity per solid angle; 1 if there is no choice
    float leaving = 0;  // per solid angle; at infinity per area perpendicular to the direction
};

// The start of a light path. For lights at infinity, it is on a disk in front of the scene's bounding sphere.
struct EmittedRay {
    Vec3 p, d;  // world space; d is the unit direction in which the light travels
    // Geometric normal of the emitter, as its shape orients it (zero for points and lights at infinity), and the index
    // of the triangle in an emissive mesh.
    Vec3 ng{0.f};
    uint32_t triangle = 0;
    Vec2 uv{0.f};       // as in EmitterHit
    float error = 0;    // of p along ng, as SpawnPoint::error, without the rounding of p
    Rgb radiance{0.f};  // along d; of a point light: intensity; of a distant light: irradiance facing it
    EmissionDensity density;
};

// Where a light at infinity appears: in unscattered camera rays (Camera), in the illumination of surfaces (Surfaces),
// or in both (All).
enum class LightAudience { All, Surfaces, Camera };

class Light {
  public:
    virtual ~Light() = default;
    virtual std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const = 0;
    // Samples emission, for paths that start at lights. Empty if these random numbers yield no light.
    virtual std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere&) const = 0;
    // Pdfs of emit() for light that leaves in direction d. `at`: the point of emission; only area lights read it.
    virtual EmissionDensity emissionDensity(const EmitterHit& at, const Vec3& d, const SceneSphere&) const = 0;
    // Approximate total emitted power, for choosing among lights. For lights at infinity it depends on the scene's
    // size.
    virtual Rgb power(float sceneRadius) const = 0;
    virtual bool isDelta() const { return false; }
    // Whether emit() starts on the surface that rays hit. Otherwise its points are approximate, and light paths from
    // them have no valid MIS weight against camera paths that hit the emitter.
    virtual bool emitsFromWhereRaysMeetIt() const { return true; }
    // Whether the light has no position: its light arrives from infinitely far away.
    virtual bool isAtInfinity() const { return false; }
    // Whether rays that leave the scene may hit the light: an environment or a sun disk. escaped() is then the radiance
    // that arrives at `from` from direction wi, and pdfEscaped() the pdf with which sample() chooses wi.
    virtual bool isInfinite() const { return false; }
    virtual Rgb escaped(const Vec3& /*from*/, const Vec3& /*wi*/) const { return Rgb(0.f); }
    virtual float pdfEscaped(const Vec3& /*from*/, const Vec3& /*wi*/) const { return 0; }
    virtual LightAudience audience() const { return LightAudience::All; }
    bool visibleToCamera() const { return audience() != LightAudience::Surfaces; }
    // Whether the light illuminates surfaces. A light that does not is visible to camera rays only and is never
    // sampled.
    bool illuminates() const { return audience() != LightAudience::Camera; }
    // Whether light may arrive from all around, so that it pays to learn which directions contribute
    // (EnvironmentGuide).
    virtual bool surrounds() const { return isInfinite(); }
    // The u in the unit square for which sample() at `from` returns direction wi.
    virtual Vec2 inverse(const Vec3& /*from*/, const Vec3& /*wi*/) const { return Vec2(0, 0); }
    // Rows of an environment's map, as a measure of its detail; 1 if it is constant.
    virtual int mapRows() const { return 1; }
    // Bounds of a finite light, or of the portal of an environment, for choosing among many lights. Empty for other
    // lights at infinity.
    virtual Bounds bounds() const { return {}; }
    // Bounds of position and direction of a finite light; by default it emits equally in all directions.
    virtual LightReach reach() const {
        LightReach r;
        r.bounds = bounds();
        r.intensity = luminance(power(0)) / (4 * kPi);
        return r;
    }
};

using LightPtr = std::shared_ptr<const Light>;

// A surface that emits light: one light for each emissive mesh or shape.
class AreaLight : public Light {
  public:
    // emit() samples points in proportion to the radiance that they emit, and directions by the cosine, within the cone
    // of the emission's profile.
    EmissionDensity emissionDensity(const EmitterHit& at, const Vec3& d, const SceneSphere&) const final;
    // Le: radiance that leaves the hit point towards wo.
    Rgb emitted(const EmitterHit& hit, const Vec3& wo) const {
        if (!twoSided_ && !(dot(hit.ng, wo) > 0)) return Rgb(0.f);
        const EmissionProfile& profile = emission_.profile();
        return profile.isEven() ? emission_.at(hit.uv) : emission_.at(hit.uv) * profile.share(hit.ng, wo);
    }
    Rgb power(float) const final {
        return radianceTimesArea() * ((twoSided_ ? 2 : 1) * kPi * emission_.profile().power());
    }
    // Pdf, per solid angle at `from`, with which sample() chooses this hit.
    virtual float pdf(const Vec3& from, const Vec3& wi, const EmitterHit& hit) const = 0;

  protected:
    AreaLight(Emission emission, bool twoSided) : emission_(std::move(emission)), twoSided_(twoSided) {}
    // Le before the profile, integrated over the surface's area.
    virtual Rgb radianceTimesArea() const = 0;
    // Pdf, per area, with which emit() chooses this point.
    virtual float originPdf(const EmitterHit& at) const = 0;
    // The result of emit() for a sampled point of the emitter.
    std::optional<EmittedRay> leave(const EmitterHit& from, const Vec2& u, const SceneSphere& scene) const;

    const Emission emission_;
    const bool twoSided_;
};

LightPtr makePointLight(const Vec3& position, const Rgb& intensity);
// The next three lights are at the origin of their own space. A spotlight shines along +z.
LightPtr makeSpotLight(const Transform& lightToWorld, const Rgb& intensity, const SpotFalloff& falloff);
// image: multiplies the intensity; empty for a uniform light. Its layout is documented where the lights are
// implemented. fovDegrees: of the image's shorter side.
LightPtr makeGoniometricLight(const Transform& lightToWorld, const Rgb& intensity, LightImage image);
LightPtr makeProjectionLight(const Transform& lightToWorld, const Rgb& intensity, float fovDegrees, LightImage image);
// direction: from lit points towards the light, world space.
LightPtr makeDistantLight(const Vec3& direction, const Rgb& radiance);
// A distant light seen as a disk. angle: its diameter, in degrees, in (0, 180]. irradiance: on a surface that faces it.
LightPtr makeSunLight(const Vec3& direction, const Rgb& irradiance, float angle,
                      LightAudience audience = LightAudience::All);

// An environment map in pbrt's lat-long layout: v = theta / pi from +z of the light's space, with row 0 at theta = 0,
// and u = phi / 2 pi.
using EnvironmentMap = LightImage;
// map: empty for a constant environment. scale multiplies the map.
LightPtr makeInfiniteLight(const Transform& lightToWorld, const Rgb& scale, EnvironmentMap map = {},
                           LightAudience audience = LightAudience::All);
// An environment that is visible only through a portal: a rectangle in world space, oriented as Portal says. Points
// outside the portal, and rays that miss it, receive nothing.
LightPtr makePortalLight(LightPtr environment, const std::array<Vec3, 4>& corners);

// Diffuse emitters (pbrt's "diffuse" area light). They emit on the side of the geometric normal, or on both sides, and
// are sampled in proportion to the radiance that they emit. (Curves are sampled uniformly, whatever image they show.)
std::shared_ptr<const AreaLight> makeMeshAreaLight(const TriangleMesh& mesh, const Emission& emission, bool twoSided);
std::shared_ptr<const AreaLight> makeShapeAreaLight(ShapePtr shape, const Emission& emission, bool twoSided);

}  // namespace drc
