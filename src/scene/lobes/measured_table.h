// A measured BRDF in the parameterization of Dupuy and Jakob, "An Adaptive Parameterization for Efficient Material
// Acquisition and Rendering" (2018): for each measured direction, f |cos| over a square that the visible microfacet
// normals of a distribution are warped to, so that few values are spent where nothing happens.
//
// The measured direction is called wo here, as the one that is given; f is the same both ways. A normal (theta, phi)
// is the point (sqrt(2 theta / pi), phi / 2 pi + 1/2) of the square. Directions are above the surface.
#pragma once
#include <optional>
#include <vector>

#include "math/square_warp.h"
#include "scene/lobes/lobe.h"

namespace drc {

// Contents of a file. All values are finite, and none is negative.
struct MeasuredData {
    // Polar angles and azimuths of wo, ascending, in radians. With one or two azimuths the surface is isotropic, and
    // phi of a normal counts from that of wo. With more, phi covers the full circle, or as much of it as symmetry
    // leaves (a half or a quarter).
    std::vector<float> theta, phi;
    SquareGrid ndfGrid, sigmaGrid, vndfGrid, lightGrid;
    std::vector<float> ndf;        // distribution of normals
    std::vector<float> sigma;      // projected area of the microfacets towards wo, in the same units
    std::vector<float> vndf;       // densities of visible normals, for each phi and theta, phi outermost
    std::vector<float> luminance;  // of colors, for each phi and theta, over the square warped by vndf; for sampling
    std::vector<Rgb> colors;       // with lightGrid, as luminance is
    bool jacobian = true;          // colors are f |cos| divided by ndf / (4 sigma), not f |cos| itself
};

class MeasuredTable {
  public:
    explicit MeasuredTable(MeasuredData data);

    LobeValue evaluate(const Vec3& wo, const Vec3& wi) const;
    // None: the normal that was chosen reflects into the surface.
    std::optional<Vec3> sample(const Vec3& wo, const Vec2& u) const;
    Rgb albedo(const Vec3& wo) const;
    // equivalentAlpha().
    float alpha() const { return alpha_; }

  private:
    // The symmetries of an anisotropic surface turn wo into the range of phi that was measured.
    struct Turn {
        float x = 1, y = 1;
        Vec3 operator()(const Vec3& w) const { return Vec3(x * w.x, y * w.y, w.z); }
    };
    Turn turnFor(const Vec3& wo) const;
    // wo and what follows from it; turned.
    struct Viewed {
        Vec3 wo;
        float phi;
        Vec2 square;
        FamilyWeights family;
    };
    Viewed viewed(const Vec3& wo) const;
    LobeValue evaluate(const Viewed& from, const Vec3& wi) const;
    std::optional<Vec3> sample(const Viewed& from, const Vec2& u) const;
    // Ratio of the solid angle of wi to the area on the square of normals. sine: of the normal's theta; cosNormal: of
    // the angle between the normal and wo.
    static float stretch(const Vec2& square, float sine, float cosNormal);
    void integrate();

    FamilyGrid family_;
    bool isotropic_, jacobian_;
    int symmetries_ = 1;  // 1, 2 or 4
    SquareTable<float> ndf_, sigma_;
    SquareWarp vndf_, light_;
    SquareTable<Rgb> colors_;
    std::vector<Rgb> albedo_;  // of each member of the family
    float alpha_ = kDiffuseAlpha;
};

}  // namespace drc
