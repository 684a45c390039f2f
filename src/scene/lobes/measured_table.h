// A measured BRDF in the parameterization of Dupuy and Jakob, "An Adaptive Parameterization for Efficient Material
// Acquisition and Rendering" (2018). For each measured direction, f |cos| is tabulated over the unit square, which is
// warped to the distribution of visible microfacet normals, so that few values are spent where there is little light.
//
// The measured direction is called wo here; f is reciprocal. A normal (theta, phi) is the point (sqrt(2 theta / pi),
// phi / 2 pi + 1/2) of the square. Directions are above the surface.
#pragma once
#include <optional>
#include <vector>

#include "math/square_warp.h"
#include "scene/lobes/lobe.h"

namespace drc {

// Contents of a file. All values are finite, and none is negative.
struct MeasuredData {
    // Polar angles and azimuths of wo, ascending, in radians. With one or two azimuths the surface is isotropic, and
    // phi of a normal is relative to that of wo. With more, phi covers the full circle, or a half or a quarter of it if
    // the surface is symmetric.
    std::vector<float> theta, phi;
    SquareGrid ndfGrid, sigmaGrid, vndfGrid, lightGrid;
    std::vector<float> ndf;        // distribution of normals
    std::vector<float> sigma;      // projected area of the microfacets towards wo, in the units of ndf
    std::vector<float> vndf;       // densities of visible normals: [phi][theta][vndfGrid]
    std::vector<float> luminance;  // of colors, for sampling: [phi][theta][lightGrid] over the square warped by vndf
    std::vector<Rgb> colors;       // same layout as luminance
    bool jacobian = true;          // colors are f |cos| divided by ndf / (4 sigma), not f |cos| itself
};

class MeasuredTable {
  public:
    explicit MeasuredTable(MeasuredData data);

    LobeValue evaluate(const Vec3& wo, const Vec3& wi) const;
    // None if the sampled normal faces away from wo, or reflects wo into the surface.
    std::optional<Vec3> sample(const Vec3& wo, const Vec2& u) const;
    Rgb albedo(const Vec3& wo) const;
    // The smallest equivalentAlpha() over the measured directions, grazing ones excepted.
    float alpha() const { return alpha_; }

  private:
    // A symmetry of an anisotropic surface that takes wo to the measured range of phi: the signs of x and y.
    struct Turn {
        float x = 1, y = 1;
        Vec3 operator()(const Vec3& w) const { return Vec3(x * w.x, y * w.y, w.z); }
    };
    Turn turnFor(const Vec3& wo) const;
    // wo after its Turn, and values that depend on wo alone.
    struct Viewed {
        Vec3 wo;
        float phi;
        Vec2 square;
        FamilyWeights family;
    };
    Viewed viewed(const Vec3& wo) const;
    LobeValue evaluate(const Viewed& from, const Vec3& wi) const;
    std::optional<Vec3> sample(const Viewed& from, const Vec2& u) const;
    // Ratio of the solid angle of wi to the area on the square of normals. square: point of the normal. sine: of the
    // normal's theta. cosNormal: cosine between the normal and wo.
    static float stretch(const Vec2& square, float sine, float cosNormal);
    void integrate();

    FamilyGrid family_;
    bool isotropic_, jacobian_;
    int symmetries_ = 1;  // 1, 2 or 4
    SquareTable<float> ndf_, sigma_;
    SquareWarp vndf_, light_;
    SquareTable<Rgb> colors_;
    std::vector<Rgb> albedo_;  // per member of the family (measured wo)
    float alpha_ = kDiffuseAlpha;
};

}  // namespace drc
