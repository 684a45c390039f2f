// Traces rays through the surfaces of a photographic lens (PBR 3e, section 6.4). Lens space is camera space: the film
// is in the plane z = 0, the lens in front of it and the scene at greater z. Lengths are in metres.
#pragma once
#include <optional>
#include <vector>

#include "scene/cameras/camera.h"

namespace drc {

class LensSystem {
  public:
    // elements: from the scene to the film; not empty.
    explicit LensSystem(std::vector<LensElement> elements);

    // The ray that leaves the lens towards the scene, for a ray that starts at the film; empty if the lens blocks it.
    struct Line {
        Vec3 o, d;
    };
    std::optional<Line> trace(const Line& fromFilm) const;

    // Paraxial properties of the whole lens: the focal length and the z of both principal planes. Object distances are
    // measured from the front plane, image distances from the rear plane.
    struct Cardinal {
        float focalLength, front, rear;
    };
    Cardinal cardinal() const;
    // Moves the lens along the axis so that objects at `distance` from the film are in focus. Throws Error if that is
    // impossible.
    void focus(float distance);

    float rearZ() const { return elements_.back().thickness; }
    float rearAperture() const { return elements_.back().aperture; }
    float frontZ() const;

  private:
    std::vector<LensElement> elements_;
};

}  // namespace drc
