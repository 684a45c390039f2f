// Camera with a photographic lens (PBR 3e, section 6.4). A film point sees the scene through the exit pupil. Rays are
// aimed at a bounding box of the pupil, so that few rays are blocked. The boxes are computed in advance, one for each
// ring of the film.
#include "base/parallel.h"
#include "math/sampler.h"
#include "scene/cameras/camera.h"
#include "scene/cameras/camera_placement.h"
#include "scene/cameras/lens_system.h"

namespace drc {
namespace {

constexpr int kRings = 64;  // number of rings between the film's centre and its corners
constexpr int kGrid = 64;   // rays along each side of the grid that determines a ring's pupil

// A bounding box of the exit pupil on the plane of the rear element.
struct PupilBox {
    float x0 = kInfinity, x1 = -kInfinity, y0 = kInfinity, y1 = -kInfinity;

    bool empty() const { return !(x0 < x1 && y0 < y1); }
    float area() const { return (x1 - x0) * (y1 - y0); }
    Vec2 at(const Vec2& u) const { return Vec2(lerp(u.x, x0, x1), lerp(u.y, y0, y1)); }
    void extend(const Vec2& p) {
        x0 = std::min(x0, p.x);
        x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y);
        y1 = std::max(y1, p.y);
    }
    void grow(float dx, float dy) {
        x0 -= dx;
        x1 += dx;
        y0 -= dy;
        y1 += dy;
    }
};

class RealisticCamera final : public Camera {
  public:
    RealisticCamera(const RealisticCameraParams& params, const FilmGeometry& film)
        : params_(params), placement_(params.worldToCamera, params.shutter), lens_(params.lens) {
        lens_.focus(params.focusDistance);
        const float diagonal = film.diagonal * 1e-3f;
        const float aspect = float(film.height) / float(film.width);
        size_.x = diagonal / std::sqrt(1 + aspect * aspect);
        size_.y = aspect * size_.x;
        radius_ = 0.5f * diagonal;
        resolution_ = Vec2(float(film.width), float(film.height));
        coneSpread_ = std::sqrt(size_.x * size_.y / (resolution_.x * resolution_.y)) / lens_.cardinal().rear;
        pupils_.resize(kRings);
        parallelFor(0, kRings, 1, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) pupils_[size_t(i)] = findPupil(i);
        });
    }

    CameraRay generateRay(const Vec2& film, const Vec2& uLens, float uTime) const override {
        // The lens rotates the image by 180 degrees.
        const Vec2 at(-(film.x / resolution_.x - 0.5f) * size_.x, (film.y / resolution_.y - 0.5f) * size_.y);
        const float r = std::sqrt(at.x * at.x + at.y * at.y);
        const PupilBox& pupil = pupils_[size_t(std::min(int(r / radius_ * kRings), kRings - 1))];
        // The boxes belong to film points on the x axis, so p is rotated about the lens axis to the film point.
        const Vec2 p = pupil.at(uLens);
        const Vec2 turn = r > 0 ? at * (1 / r) : Vec2(1, 0);
        const Vec3 start(at.x, at.y, 0);
        const Vec3 d = normalize(Vec3(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y, lens_.rearZ()) - start);
        const auto line = lens_.trace({start, d});
        CameraRay result;
        if (!line) {
            result.weight = 0;
            return result;
        }
        const float cos4 = sqr(sqr(d.z));
        result.weight = params_.simpleWeighting
                            ? cos4 * pupil.area() / pupils_.front().area()
                            : cos4 * pupil.area() / sqr(lens_.rearZ()) * (params_.shutter.close - params_.shutter.open);
        Ray& ray = result.ray;
        ray = placement_.ray(line->o, line->d, uTime);
        // The spread of a pinhole camera with the pinhole in the rear principal plane.
        const float cosine = line->d.z;
        ray.coneSpread = coneSpread_ * cosine * std::sqrt(cosine);
        return result;
    }

    Vec3 position() const override { return placement_.position(); }
    Vec3 up() const override { return placement_.up(); }
    const Shutter& shutter() const override { return placement_.shutter(); }
    std::unique_ptr<Camera> withFilm(const FilmGeometry& film) const override {
        return std::make_unique<RealisticCamera>(params_, film);
    }
    std::unique_ptr<Camera> placed(const Transform& worldToCamera, const FilmGeometry& film) const override {
        RealisticCameraParams params = params_;
        params.worldToCamera = {worldToCamera, worldToCamera};
        return std::make_unique<RealisticCamera>(params, film);
    }
    Transform worldToCameraAt(float u) const override { return placement_.toWorldAt(shutter().motion(u)).inverse(); }

  private:
    PupilBox findPupil(int ring) const {
        const float reach = 1.5f * lens_.rearAperture();
        const PupilBox whole{-reach, reach, -reach, reach};
        // Two passes: the first covers the whole region that the pupil may lie in, the second the box that the first
        // found.
        PupilBox box = whole;
        for (int pass = 0; pass < 2; ++pass) {
            PupilBox found;
            for (int i = 0; i < kGrid * kGrid; ++i) {
                Sampler sampler{uint64_t(ring), uint32_t(i)};
                const float film = radius_ * (float(ring) + sampler.get1D()) / kRings;
                const Vec2 p = box.at(Vec2((float(i % kGrid) + 0.5f) / kGrid, (float(i / kGrid) + 0.5f) / kGrid));
                if (lens_.trace({Vec3(film, 0, 0), Vec3(p.x - film, p.y, lens_.rearZ())})) found.extend(p);
            }
            // Enlarged because the pupil may extend beyond the outermost unblocked rays of the grid, and for other film
            // points in the ring.
            const float dx = 2 * (box.x1 - box.x0) / kGrid, dy = 2 * (box.y1 - box.y0) / kGrid;
            if (found.x0 > found.x1) return pass == 0 ? whole : box;
            found.grow(dx, dy);
            box = found;
        }
        return box;
    }

    RealisticCameraParams params_;
    CameraPlacement placement_;
    LensSystem lens_;
    Vec2 size_;             // of the film, in metres
    float radius_ = 0;      // distance from the film's centre to its corners
    Vec2 resolution_;       // in pixels
    float coneSpread_ = 0;  // Ray::coneSpread at the film's centre
    std::vector<PupilBox> pupils_;
};

}  // namespace

std::unique_ptr<Camera> makeRealisticCamera(const RealisticCameraParams& params, const FilmGeometry& film) {
    return std::make_unique<RealisticCamera>(params, film);
}

}  // namespace drc
