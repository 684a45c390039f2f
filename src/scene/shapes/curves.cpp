#include "scene/shapes/curves.h"

#include <fmt/core.h>

#include "base/memory.h"
#include "math/frame.h"
#include "scene/tracing_memory.h"

namespace drc {
namespace {

constexpr int kStepsPerPiece = 4;  // cells of lengths_ per piece
constexpr int kMaxPieces = 64;     // per curve

// The blossom of a cubic Bezier curve; its values are the control points of parts of the curve (PBR 3e, section 3.7).
Vec3 blossom(const std::array<Vec3, 4>& c, float u, float v, float w) {
    const auto mix = [](const Vec3& a, const Vec3& b, float t) { return a * (1 - t) + b * t; };
    const Vec3 a = mix(c[0], c[1], u), b = mix(c[1], c[2], u), d = mix(c[2], c[3], u);
    return mix(mix(a, b, v), mix(b, d, v), w);
}

std::array<Vec3, 4> partOf(const std::array<Vec3, 4>& c, float u0, float u1) {
    return {blossom(c, u0, u0, u0), blossom(c, u0, u0, u1), blossom(c, u0, u1, u1), blossom(c, u1, u1, u1)};
}

// Number of pieces such that the kLines chords of each deviate from the curve by at most a fiftieth of its width. A
// chord over 1/n of the parameter range deviates by at most |second derivative| / (8 n^2), and the second derivative is
// at most 6 times the second difference of the control points.
int piecesFor(const std::array<Vec3, 4>& c, float width) {
    const float bend = std::max(length(c[0] - c[1] * 2.f + c[2]), length(c[1] - c[2] * 2.f + c[3]));
    const float lines = std::sqrt(6 * bend / (8 * 0.02f * width));
    return std::isfinite(lines) ? int(std::clamp(std::ceil(lines / Curves::kLines), 1.f, float(kMaxPieces))) : 1;
}

// Distance along a ray in direction d (unit) to a point of a curve that faces the ray. axis: the point of the curve's
// axis, relative to the ray's origin. The distance is slightly shorter than to the axis, so that the line segments that
// Embree intersects do not occlude the hit point.
float depthFacing(const Vec3& axis, const Vec3& d, float radius) { return dot(d, axis) - 0.25f * radius; }

// Number of pieces of a ribbon such that its normal rotates by at most 15 degrees within each. Embree represents the
// edges by cubic curves, which would deviate visibly for larger rotations.
int piecesForTurn(const Vec3& n0, const Vec3& n1) {
    return int(std::ceil(std::acos(std::clamp(dot(n0, n1), -1.f, 1.f)) * (12 / kPi)));
}

// Control points of a Bezier curve from n0 to n1 (unit) whose tangents at the ends are those of the circular arc
// between them.
std::array<Vec3, 4> arcBetween(const Vec3& n0, const Vec3& n1) {
    const float cosine = std::clamp(dot(n0, n1), -1.f, 1.f), angle = std::acos(cosine), sine = std::sin(angle);
    if (!(sine > 1e-4f)) return {n0, n0 * (2 / 3.f) + n1 * (1 / 3.f), n0 * (1 / 3.f) + n1 * (2 / 3.f), n1};
    const float step = angle / (3 * sine);
    return {n0, n0 + (n1 - n0 * cosine) * step, n1 + (n0 - n1 * cosine) * step, n1};
}

// Intersection with a triangle: distance and barycentric coordinates (Moeller and Trumbore, 1997).
struct TriangleHit {
    float t, b1, b2;
};
std::optional<TriangleHit> intersectTriangle(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    using Vec3d = Imath::V3d;
    const Vec3d e1 = Vec3d(b) - Vec3d(a), e2 = Vec3d(c) - Vec3d(a), d(ray.d), s = Vec3d(ray.o) - Vec3d(a);
    const Vec3d h = d.cross(e2), q = s.cross(e1);
    const double determinant = e1.dot(h);
    if (determinant == 0) return {};
    const double b1 = s.dot(h) / determinant, b2 = d.dot(q) / determinant;
    if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= 1)) return {};
    return TriangleHit{float(e2.dot(q) / determinant), float(b1), float(b2)};
}

}  // namespace

int Curves::piecesOf(const std::array<Vec3, 4>& points, const std::array<float, 2>& widths,
                     const std::array<Vec3, 2>& normals) const {
    if (points[0] == points[1] && points[1] == points[2] && points[2] == points[3]) return 0;
    const int pieces = piecesFor(points, std::max(widths[0], widths[1]));
    return type_ == CurveType::Ribbon ? std::max(pieces, piecesForTurn(normals[0], normals[1])) : pieces;
}

void Curves::reserve(size_t pieces) {
    const size_t wanted = ranges_.size() + pieces;
    if (wanted <= ranges_.capacity()) return;
    // Doubles the capacity like std::vector, so that appending many sets one by one does not copy everything each time.
    const size_t room = std::max(wanted, ranges_.empty() ? 0 : 2 * ranges_.capacity());
    const bool ribbon = type_ == CurveType::Ribbon;
    const double bytes = 4 * sizeof(ControlPoint) + (ribbon ? 4 * sizeof(ControlNormal) : 0) + sizeof(Vec2);
    const MemoryClaim memory(double(room) * bytes + double(wanted) * kTracingBytesPerCurvePiece,
                             fmt::format("curves of {} pieces", wanted));
    ranges_.reserve(room);
    points_.reserve(4 * room);
    if (ribbon) normals_.reserve(4 * room);
}

void Curves::add(const std::array<Vec3, 4>& points, const std::array<float, 2>& widths,
                 const std::array<Vec3, 2>& normals) {
    const int pieces = piecesOf(points, widths, normals);
    const std::array<Vec3, 4> arc = type_ == CurveType::Ribbon ? arcBetween(normals[0], normals[1]) : points;
    for (int i = 0; i < pieces; ++i) {
        const float u0 = float(i) / float(pieces), u1 = float(i + 1) / float(pieces);
        const auto part = partOf(points, u0, u1), arcPart = partOf(arc, u0, u1);
        ranges_.push_back(Vec2(u0, u1));
        for (size_t k = 0; k < 4; ++k) {
            const float radius = 0.5f * lerp(lerp(float(k) / 3, u0, u1), widths[0], widths[1]);
            points_.push_back({part[k], radius});
            if (type_ == CurveType::Ribbon) normals_.push_back({arcPart[k]});
            // Bounds::extend() ignores NaN, because comparisons with NaN are false. Infinite bounds make the error
            // visible.
            if (!std::isfinite(part[k].x + part[k].y + part[k].z + radius)) bounds_.extend(Vec3(kInfinity));
            bounds_.extend(part[k] - Vec3(radius));
            bounds_.extend(part[k] + Vec3(radius));
        }
    }
}

void Curves::append(const Curves& other) {
    reserve(other.ranges_.size());
    points_.insert(points_.end(), other.points_.begin(), other.points_.end());
    normals_.insert(normals_.end(), other.normals_.begin(), other.normals_.end());
    ranges_.insert(ranges_.end(), other.ranges_.begin(), other.ranges_.end());
    bounds_.extend(other.bounds_);
}

Curves::Point Curves::at(uint32_t piece, float u) const {
    const ControlPoint* c = &points_[4 * size_t(piece)];
    const float v = 1 - u;
    Point r;
    r.p = c[0].p * (v * v * v) + c[1].p * (3 * v * v * u) + c[2].p * (3 * v * u * u) + c[3].p * (u * u * u);
    r.d1 = ((c[1].p - c[0].p) * (v * v) + (c[2].p - c[1].p) * (2 * v * u) + (c[3].p - c[2].p) * (u * u)) * 3.f;
    r.d2 = ((c[0].p - c[1].p * 2.f + c[2].p) * v + (c[1].p - c[2].p * 2.f + c[3].p) * u) * 6.f;
    // The derivative is zero where control points coincide; the direction from the first to the last control point
    // replaces it.
    if (!(lengthSquared(r.d1) > 0)) r.d1 = c[3].p - c[0].p;
    r.radius = lerp(u, c[0].radius, c[3].radius);
    r.radiusStep = c[3].radius - c[0].radius;
    return r;
}

Vec3 Curves::normalAt(uint32_t piece, float u, Vec3* derivative) const {
    const ControlNormal* c = &normals_[4 * size_t(piece)];
    const float v = 1 - u;
    if (derivative)
        *derivative =
            ((c[1].n - c[0].n) * (v * v) + (c[2].n - c[1].n) * (2 * v * u) + (c[3].n - c[2].n) * (u * u)) * 3.f;
    return c[0].n * (v * v * v) + c[1].n * (3 * v * v * u) + c[2].n * (3 * v * u * u) + c[3].n * (u * u * u);
}

Vec3 Curves::across(const Vec3& facing, const Vec3& along) {
    const Vec3 b = cross(facing, along);
    const float l2 = lengthSquared(b);
    if (!(l2 > 1e-12f * lengthSquared(along))) return Frame::fromNormal(normalize(along)).s;  // seen end-on
    return b * (1 / std::sqrt(l2));
}

ShapeHit Curves::hitAt(uint32_t piece, float u, const Ray& ray, float t) const {
    const Point c = at(piece, u);
    const bool ribbon = type_ == CurveType::Ribbon;
    const Vec3 b = across(ribbon ? normalAt(piece, u) : normalize(ray.d), c.d1);
    const float s = c.radius > 0 ? std::clamp(dot(ray.o + ray.d * t - c.p, b) / c.radius, -1.f, 1.f) : 0.f;
    const Vec2 range = ranges_[piece];
    const Vec3 n = normalize(cross(c.d1, b)) * (ribbon ? 1.f : -1.f);
    ShapeHit hit;
    hit.t = t;
    hit.p = ray.o + ray.d * t;
    hit.part = piece;
    hit.uv = Vec2(lerp(u, range.x, range.y), 0.5f + 0.5f * s);
    hit.dpdu = c.d1 * (1 / (range.y - range.x));
    hit.ng = n;
    hit.dpdv = b * (2 * c.radius);
    if (type_ == CurveType::Cylinder) {
        const float angle = 0.5f * kPi * s, cosine = std::cos(angle), sine = std::sin(angle);
        hit.ng = n * cosine - b * sine;
        hit.dpdv = (b * cosine + n * sine) * (2 * c.radius);
    } else if (type_ == CurveType::Tube) {
        const float towards = std::sqrt(1 - s * s);
        hit.ng = n * towards + b * s;
        hit.dpdv = (b * towards - n * s) * (2 * c.radius);
    }
    if (flipNormal_) hit.ng = -hit.ng;
    if (mirrored_) {
        hit.uv.y = 1 - hit.uv.y;
        hit.dpdv = -hit.dpdv;
    }
    return hit;
}

std::optional<ShapeHit> Curves::intersect(const Ray& ray, float tMin) const {
    constexpr int kFineLines = 4 * kLines;
    float nearest = ray.tMax, nearestU = 0;
    std::optional<uint32_t> found;
    for (uint32_t piece = 0; piece < pieceCount(); ++piece) {
        Vec3 left(0.f), right(0.f);
        for (int i = 0; i <= kFineLines; ++i) {
            const float u = float(i) / kFineLines;
            const Point c = at(piece, u);
            const Vec3 b = across(type_ == CurveType::Ribbon ? normalAt(piece, u) : normalize(ray.d), c.d1);
            const Vec3 nextLeft = c.p - b * c.radius, nextRight = c.p + b * c.radius;
            const auto take = [&](const std::optional<TriangleHit>& h, float along) {
                if (!h || !(h->t > tMin && h->t < nearest)) return;
                nearest = h->t;
                nearestU = u - (1 - along) / kFineLines;
                found = piece;
            };
            if (i > 0) {
                const auto first = intersectTriangle(ray, left, right, nextRight);
                take(first, first ? first->b2 : 0);
                const auto second = intersectTriangle(ray, left, nextRight, nextLeft);
                take(second, second ? second->b1 + second->b2 : 0);
            }
            left = nextLeft;
            right = nextRight;
        }
    }
    if (!found) return {};
    return hitAt(*found, nearestU, ray, nearest);
}

const Distribution1D& Curves::lengths() const {
    std::call_once(lengthsOnce_, [this] {
        constexpr double kBytesPerStep =
            sizeof(float) + sizeof(double) + sizeof(int);  // of `steps` and of the distribution
        const MemoryClaim memory(double(pieceCount()) * kStepsPerPiece * kBytesPerStep,
                                 fmt::format("a light of curves of {} pieces", pieceCount()));
        std::vector<float> steps;
        steps.reserve(size_t(pieceCount()) * kStepsPerPiece);
        for (uint32_t piece = 0; piece < pieceCount(); ++piece)
            for (int i = 0; i < kStepsPerPiece; ++i) {
                const Point c = at(piece, (float(i) + 0.5f) / kStepsPerPiece);
                steps.push_back(c.radius * length(c.d1));
            }
        lengths_ = Distribution1D(steps);
    });
    return lengths_;
}

float Curves::area() const {
    const float radiusTimesLength = float(lengths().integral() * pieceCount());
    return radiusTimesLength * (type_ == CurveType::Ribbon ? 2 : 2 * kPi);
}

Curves::Chosen Curves::choose(float u) const {
    const Sample1D s = lengths().sampleContinuous(u);
    const float inPiece = (float(s.index % kStepsPerPiece) + s.local) / kStepsPerPiece;
    return {uint32_t(s.index / kStepsPerPiece), std::min(inPiece, kOneMinusEpsilon),
            lengths().probability(s.index) * kStepsPerPiece};
}

ShapeSample Curves::sample(const Vec2& u) const {
    const Chosen chosen = choose(u.x);
    const Point c = at(chosen.piece, chosen.u);
    ShapeSample s;
    if (type_ == CurveType::Ribbon) {
        const Vec3 b = across(normalAt(chosen.piece, chosen.u), c.d1);
        s.p = c.p + b * (c.radius * (2 * u.y - 1));
        s.ng = normalize(cross(c.d1, b));
    } else {
        const Frame frame = Frame::fromNormal(normalize(c.d1));
        s.ng = frame.s * std::cos(2 * kPi * u.y) + frame.t * std::sin(2 * kPi * u.y);
        s.p = c.p + s.ng * c.radius;
    }
    if (flipNormal_) s.ng = -s.ng;
    const float breadth = (type_ == CurveType::Ribbon ? 2 : 2 * kPi) * c.radius;
    s.pdf = chosen.pdf / (breadth * length(c.d1));
    if (!std::isfinite(s.pdf)) s.pdf = 0;
    s.uv = Vec2(lerp(chosen.u, ranges_[chosen.piece].x, ranges_[chosen.piece].y), u.y);
    if (mirrored_) s.uv.y = 1 - s.uv.y;
    s.part = chosen.piece;
    return s;
}

ShapeSample Curves::sampleFrom(const Vec3& p, const Vec2& u) const {
    const Chosen chosen = choose(u.x);
    const Point c = at(chosen.piece, chosen.u);
    const bool ribbon = type_ == CurveType::Ribbon;
    const float s = 2 * u.y - 1;
    const Vec3 b = across(ribbon ? normalAt(chosen.piece, chosen.u) : normalize(c.p - p), c.d1);
    Ray ray;
    ray.o = p;
    ray.d = normalize(c.p + b * (s * c.radius) - p);
    const float t = ribbon ? length(c.p + b * (s * c.radius) - p) : depthFacing(c.p - p, ray.d, c.radius);
    if (!(t > 0)) return {p, ray.d, 0};
    const ShapeHit hit = hitAt(chosen.piece, chosen.u, ray, t);
    return {p + ray.d * t, hit.ng, density(p, chosen, s), hit.uv, chosen.piece};
}

float Curves::inPiece(uint32_t piece, float u) const {
    const Vec2 range = ranges_[piece];
    return std::clamp((u - range.x) / (range.y - range.x), 0.f, kOneMinusEpsilon);
}

Vec2 Curves::uvSeenFrom(const ShapeSample& sample, const Vec3& d) const {
    Ray ray;
    ray.o = sample.p;
    ray.d = -d;
    return hitAt(sample.part, inPiece(sample.part, sample.uv.x), ray, 0).uv;
}

float Curves::pdfFrom(const Vec3& p, const Vec3&, const ShapePoint& hit) const {
    const float u = inPiece(hit.part, hit.uv.x);
    const int step = int(hit.part) * kStepsPerPiece + int(u * kStepsPerPiece);
    return density(p, {hit.part, u, lengths().probability(step) * kStepsPerPiece},
                   (mirrored_ ? -1.f : 1.f) * (2 * hit.uv.y - 1));
}

float Curves::density(const Vec3& p, const Chosen& chosen, float s) const {
    const Point c = at(chosen.piece, chosen.u);
    // The normal of the sampled side, and its derivative with respect to the piece's parameter.
    Vec3 facing(0.f), turn(0.f);
    if (type_ == CurveType::Ribbon) {
        facing = normalAt(chosen.piece, chosen.u, &turn);
    } else {
        const float distance = length(c.p - p);
        facing = (c.p - p) / distance;
        turn = (c.d1 - facing * dot(facing, c.d1)) / distance;
    }
    const Vec3 q = cross(facing, c.d1), b = across(facing, c.d1);
    const Vec3 qStep = cross(turn, c.d1) + cross(facing, c.d2);
    const Vec3 bStep = (qStep - b * dot(b, qStep)) / length(q);
    // Derivatives of the point c + s r b with respect to u and s; the solid angle follows from their cross product.
    const Vec3 byU = c.d1 + b * (s * c.radiusStep) + bStep * (s * c.radius), byS = b * c.radius;
    const Vec3 d = c.p + b * (s * c.radius) - p;
    const float distance = length(d);
    if (type_ != CurveType::Ribbon && !(depthFacing(c.p - p, d / distance, c.radius) > 0)) return 0;
    const float solidAngle = std::abs(dot(cross(byU, byS), d)) / (distance * distance * distance);
    const float pdf = chosen.pdf * 0.5f / solidAngle;
    return std::isfinite(pdf) ? pdf : 0;
}

}  // namespace drc
