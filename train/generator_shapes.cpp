#include "generator_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace drc::interior {
namespace {

void append(std::string& s, const Vec3& p) {
    fmt::format_to(std::back_inserter(s), " {:.5g} {:.5g} {:.5g}", p.x, p.y, p.z);
}

// A control cage of `around` x `along` vertices on a surface of revolution, closed by two poles. `radius(t)` for t in
// (0, 1).
template <typename Radius>
std::string closedCage(int around, int along, float height, Radius radius, int levels) {
    std::string points, indices;
    append(points, {0, 0, 0});
    for (int j = 0; j < along; ++j) {
        const float t = (static_cast<float>(j) + 0.5f) / static_cast<float>(along);
        for (int i = 0; i < around; ++i) {
            const float phi = 2 * kPi * static_cast<float>(i) / static_cast<float>(around);
            const float r = radius(t);
            append(points, {r * std::cos(phi), r * std::sin(phi), height * t});
        }
    }
    append(points, {0, 0, height});
    const int last = 1 + around * along;
    const auto at = [&](int j, int i) { return 1 + j * around + i % around; };
    const auto triangle = [&](int a, int b, int c) {
        fmt::format_to(std::back_inserter(indices), " {} {} {}", a, b, c);
    };
    for (int i = 0; i < around; ++i) {
        triangle(0, at(0, i + 1), at(0, i));
        triangle(last, at(along - 1, i), at(along - 1, i + 1));
        for (int j = 0; j + 1 < along; ++j) {
            triangle(at(j, i), at(j, i + 1), at(j + 1, i + 1));
            triangle(at(j, i), at(j + 1, i + 1), at(j + 1, i));
        }
    }
    return fmt::format(R"("loopsubdiv" "integer nlevels" [ {} ] "integer indices" [{} ] "point P" [{} ])", levels,
                       indices, points);
}

}  // namespace

void drawQuadric(const Pen& pen, const Vec3& base, float size, float height, Rng& rng, int material) {
    const float r = size / 2, phimax = rng.chance(0.7f) ? 360 : rng.uniform(150, 340);
    const auto draw = [&](const Vec3& at, const std::string& shape) {
        pen.shape(base + at, fmt::format(R"({} "float phimax" [ {:.5g} ])", shape, phimax), material);
    };
    switch (rng.integer(0, 4)) {
        case 0: {  // a dome or a bowl
            const float s = std::min(r, height / 2), cut = rng.uniform(-0.3f, 0.6f) * s;
            draw({0, 0, s}, rng.chance(0.5f)
                                ? fmt::format(R"("sphere" "float radius" [ {:.5g} ] "float zmin" [ {:.5g} ])", s, -cut)
                                : fmt::format(R"("sphere" "float radius" [ {:.5g} ] "float zmax" [ {:.5g} ])", s, cut));
            break;
        }
        case 1:
            draw({0, 0, 0},
                 fmt::format(R"("cylinder" "float radius" [ {:.5g} ] "float zmin" [ 0 ] "float zmax" [ {:.5g} ])", r,
                             height));
            break;
        case 2:
            draw({0, 0, 0}, fmt::format(R"("cone" "float radius" [ {:.5g} ] "float height" [ {:.5g} ])", r, height));
            break;
        case 3:
            draw({0, 0, 0},
                 fmt::format(R"("paraboloid" "float radius" [ {:.5g} ] "float zmin" [ 0 ] "float zmax" [ {:.5g} ])", r,
                             height));
            break;
        default: {  // a waist at z = 0
            const float turn = rng.uniform(0.6f, 2.2f), h = height / 2;
            draw({0, 0, h},
                 fmt::format(R"("hyperboloid" "point p1" [ {:.5g} 0 {:.5g} ] "point p2" [ {:.5g} {:.5g} {:.5g} ])", r,
                             -h, r * std::cos(turn), r * std::sin(turn), h));
            break;
        }
    }
}

void drawSubdivided(const Pen& pen, const Vec3& base, float size, float height, Rng& rng, int material) {
    // The limit surface is well inside its control cage.
    const float r = size * 0.62f, h = height;
    const int around = rng.integer(4, 8), along = rng.integer(2, 5);
    const float lump = rng.uniform(0, 0.5f), waist = rng.uniform(-0.5f, 0.5f);
    pen.shape(base,
              closedCage(
                  around, along, h,
                  [&](float t) {
                      const float bulge = 1 - waist * std::cos(2 * kPi * t);
                      return r * std::min(1.f, bulge * (1 - lump * rng.uniform()));
                  },
                  rng.integer(2, 3)),
              material);
    pen.solid(base + Vec3(-0.2f * size, -0.2f * size, 0.2f * h), base + Vec3(0.2f * size, 0.2f * size, 0.8f * h));
}

void drawTuft(const Pen& pen, const Vec3& base, float spread, float height, int blades, Rng& rng, int material) {
    const char* kind = rng.chance(0.5f) ? "flat" : "cylinder";
    const float width = height * rng.uniform(0.008f, 0.03f);
    for (int i = 0; i < blades; ++i) {
        const float phi = rng.uniform(0, 2 * kPi), out = spread * std::sqrt(rng.uniform()),
                    top = height * rng.uniform(0.6f, 1);
        const float droop = rng.uniform(0.6f, 1.1f);
        const Vec3 away(std::cos(phi), std::sin(phi), 0);
        std::string points;
        append(points, away * (0.12f * out));
        append(points, away * (0.2f * out) + Vec3(0, 0, 0.45f * top));
        append(points, away * (0.5f * out) + Vec3(0, 0, 0.9f * top));
        append(points, away * out + Vec3(0, 0, droop * top));
        pen.shape(
            base,
            fmt::format(
                R"("curve" "string type" [ "{}" ] "point P" [{} ] "float width0" [ {:.4g} ] "float width1" [ {:.4g} ])",
                kind, points, width, width * 0.25f),
            material);
    }
}

}  // namespace drc::interior
