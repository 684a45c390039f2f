// Rays through the surfaces of a photographic lens (PBR 3e, section 6.4). Lens space is the camera's: the film in the
// plane z = 0, the lens before it, the scene at greater z. Metres.
#pragma once
#include <optional>
#include <vector>

#include "scene/camera.h"

namespace drc {

class LensSystem {
  public:
    // From the scene to the film; not empty.
    explicit LensSystem(std::vector<LensElement> elements);

    // The ray that leaves the lens where this one, from the film, meets it. None: something in the lens stops it.
    struct Line {
        Vec3 o, d;
    };
    std::optional<Line> trace(const Line& fromFilm) const;

    // Of the lens as a whole, by paraxial optics: the focal length, and where its two principal planes stand. Object
    // distances are measured from the front one, image distances from the rear one.
    struct Cardinal {
        float focalLength, front, rear;
    };
    Cardinal cardinal() const;
    // Moves the lens along the axis so that what is `distance` from the film is sharp. Throws Error if it cannot be.
    void focus(float distance);

    float rearZ() const { return elements_.back().thickness; }
    float rearAperture() const { return elements_.back().aperture; }
    float frontZ() const;

  private:
    std::vector<LensElement> elements_;
};

}  // namespace drc
