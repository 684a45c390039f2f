#include "scene/cameras/lens_system.h"

#include <fmt/core.h>

#include "base/error.h"

namespace drc {
namespace {

// Lens files give aperture stops the index of refraction zero, which stands for air.
float etaOf(const LensElement& e) { return e.eta > 0 ? e.eta : 1; }

// The focal length, and the distance from the last surface to the focal point behind it.
struct Focus {
    double focalLength, back;
};

// A paraxial ray, initially parallel to the axis at height 1, through surfaces in the order in which light meets them.
struct ParaxialRay {
    double height = 1, slope = 0;
    // radius: positive if the centre lies beyond the surface.
    void refract(double radius, double etaBefore, double etaAfter) {
        const double power = radius != 0 ? (etaAfter - etaBefore) / radius : 0;
        slope = (etaBefore * slope - height * power) / etaAfter;
    }
    Focus focus() const { return {-1 / slope, -height / slope}; }
};

// Refracts d (unit) at a surface with the unit normal n, which points against d. eta: index of refraction on the side
// from which d arrives over that on the other side. Empty for total internal reflection.
std::optional<Vec3> refracted(const Vec3& d, const Vec3& n, float eta) {
    const float cosI = -dot(d, n), sin2T = eta * eta * std::max(0.f, 1 - cosI * cosI);
    if (sin2T >= 1) return {};
    return d * eta + n * (eta * cosI - std::sqrt(1 - sin2T));
}

}  // namespace

LensSystem::LensSystem(std::vector<LensElement> elements) : elements_(std::move(elements)) {}

std::optional<LensSystem::Line> LensSystem::trace(const Line& fromFilm) const {
    Vec3 o = fromFilm.o, d = normalize(fromFilm.d);
    float z = 0;
    for (size_t i = elements_.size(); i-- > 0;) {
        const LensElement& e = elements_[i];
        z += e.thickness;
        Vec3 normal(0, 0, -1);
        if (!(d.z > 0)) return {};
        if (e.radius == 0) {
            o += d * ((z - o.z) / d.z);
        } else {
            // The ray intersects the whole sphere twice; the lens surface is the side at the vertex z.
            const Vec3 fromCenter = o - Vec3(0, 0, z - e.radius);
            const float b = dot(fromCenter, d), c = lengthSquared(fromCenter) - sqr(e.radius);
            const float discriminant = b * b - c;
            if (discriminant < 0) return {};
            const float root = std::sqrt(discriminant);
            const float t = e.radius < 0 ? -b - root : -b + root;
            if (t < 0) return {};
            o += d * t;
            normal = faceForward(normalize(o - Vec3(0, 0, z - e.radius)), -d);
        }
        if (o.x * o.x + o.y * o.y > sqr(e.aperture)) return {};
        if (e.radius == 0) continue;
        const float etaBefore = etaOf(e), etaAfter = i > 0 ? etaOf(elements_[i - 1]) : 1;
        const auto next = refracted(d, normal, etaBefore / etaAfter);
        if (!next) return {};
        d = normalize(*next);
    }
    return Line{o, d};
}

float LensSystem::frontZ() const {
    float z = 0;
    for (const LensElement& e : elements_) z += e.thickness;
    return z;
}

LensSystem::Cardinal LensSystem::cardinal() const {
    // The rear principal plane follows from a ray that arrives from the scene, the front one from a ray from the film.
    ParaxialRay in;
    double eta = 1;
    for (size_t i = 0; i < elements_.size(); ++i) {
        in.refract(double(elements_[i].radius), eta, double(etaOf(elements_[i])));
        eta = double(etaOf(elements_[i]));
        if (i + 1 < elements_.size()) in.height += in.slope * double(elements_[i].thickness);
    }
    ParaxialRay out;
    for (size_t i = elements_.size(); i-- > 0;) {
        out.refract(-double(elements_[i].radius), double(etaOf(elements_[i])),
                    i > 0 ? double(etaOf(elements_[i - 1])) : 1.0);
        if (i > 0) out.height += out.slope * double(elements_[i - 1].thickness);
    }
    const Focus rear = in.focus(), front = out.focus();
    Cardinal r;
    r.focalLength = float(rear.focalLength);
    r.rear = float(double(rearZ()) - (rear.back - rear.focalLength));
    r.front = float(double(frontZ()) + (front.back - front.focalLength));
    return r;
}

void LensSystem::focus(float distance) {
    // Solves the thin-lens equation 1 / object + 1 / image = 1 / f, where moving the lens by m reduces the object
    // distance and increases the image distance by m. The lens is first reset to the film, so that the result does not
    // depend on its previous position, to the last bit.
    elements_.back().thickness = 0;
    const Cardinal c = cardinal();
    const double f = double(c.focalLength), object = double(distance - c.front), image = double(c.rear);
    if (!(f > 0) || !std::isfinite(f)) throw Error("the lens does not focus light: its focal length is not positive");
    const double total = object + image, root = total * (total - 4 * f);
    if (!(total > 0 && root >= 0))
        throw Error(fmt::format("the lens, of focal length {:.4g}, cannot be focused as near as {:g}", f, distance));
    const double move = 0.5 * (object - image - std::sqrt(root));
    const float thickness = float(move);
    if (!(thickness > 0))
        throw Error(fmt::format("the lens cannot be focused at {:g}: it would have to be behind the film", distance));
    elements_.back().thickness = thickness;
}

}  // namespace drc
