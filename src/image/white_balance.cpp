#include "image/white_balance.h"

#include "image/color.h"

namespace drc {
namespace {

using Matrix = std::array<Vec3, 3>;

const Matrix kBradford{Vec3(0.8951f, 0.2664f, -0.1614f), Vec3(-0.7502f, 1.7135f, 0.0367f),
                       Vec3(0.0389f, -0.0685f, 1.0296f)};

Vec3 times(const Matrix& m, const Vec3& v) { return Vec3(dot(m[0], v), dot(m[1], v), dot(m[2], v)); }

Matrix inverse(const Matrix& m) {
    const Vec3 a = cross(m[1], m[2]), b = cross(m[2], m[0]), c = cross(m[0], m[1]);
    const float scale = 1 / dot(m[0], a);
    return {Vec3(a.x, b.x, c.x) * scale, Vec3(a.y, b.y, c.y) * scale, Vec3(a.z, b.z, c.z) * scale};
}

}  // namespace

Rgb RgbMatrix::ofVariance(const Rgb& variance) const {
    Rgb bound;
    for (int i = 0; i < 3; ++i) {
        float deviation = 0;
        for (int k = 0; k < 3; ++k) deviation += std::abs(rows[size_t(i)][k]) * safeSqrt(variance[k]);
        bound[i] = sqr(deviation);
    }
    return bound;
}

RgbMatrix whiteBalance(const Rgb& light) {
    static const Matrix fromCones = inverse(kBradford);
    const Vec3 source = times(kBradford, rgbToXyz(light) * (1 / luminance(light)));
    const Vec3 target = times(kBradford, kWhiteXyz);
    RgbMatrix result;
    for (int column = 0; column < 3; ++column) {
        const Vec3 cones = times(kBradford, rgbToXyz(Rgb(float(column == 0), float(column == 1), float(column == 2))));
        const Rgb balanced = xyzToRgb(times(fromCones, cones * target / source));
        for (int row = 0; row < 3; ++row) result.rows[size_t(row)][column] = balanced[row];
    }
    return result;
}

Rgb daylight(float kelvin) {
    const double t = 1000 / double(kelvin);
    const double x = kelvin <= 7000 ? -4.6070 * t * t * t + 2.9678 * t * t + 0.09911 * t + 0.244063
                                    : -2.0064 * t * t * t + 1.9018 * t * t + 0.24748 * t + 0.237040;
    const double y = -3 * x * x + 2.870 * x - 0.275;
    return xyzToRgb(Vec3(float(x / y), 1, float((1 - x - y) / y)));
}

}  // namespace drc
