#include "transport/window_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/parallel.h"
#include "math/rng.h"
#include "math/sampler.h"
#include "math/warp.h"
#include "transport/to_surface.h"

namespace drc {
namespace {

constexpr uint64_t kStream = 0x57494e444f57;  // of random numbers
// Number of rays from each surface that a view ray hits, and from each surface that those rays hit.
constexpr int kFirstRays = 4, kSecondRays = 3;
// Bounds on the share of all rays that leave the scene. If fewer do, windows do not matter; if more, the scene is no
// room.
constexpr double kFewestLeave = 0.001, kMostLeave = 0.35;
constexpr size_t kFewestRays = 30;  // that must leave through a window
// All windows together must explain this share of the rays that leave the scene, and each window this share: the rays
// must pass through them. Many of the other rays leave from objects outside.
constexpr double kExplainedTogether = 0.2, kExplainedByOne = 0.03;
constexpr size_t kMostWindows = 8;
// A larger opening, in squares of the median ray length, is the sky above objects outside.
constexpr float kLargest = 10;
// At least this share of the light that surfaces would sample in a window must arrive unoccluded.
constexpr double kFewestArrive = 0.1;
constexpr int kTrials = 512;
// Sampling through windows must have this many times the efficiency of sampling the whole sky: it takes longer, and a
// guide that learns makes up for a part of the difference.
constexpr double kGain = 1.5;
constexpr int kTrialsOfAll = 4096;

// Hits lie in one plane if the cosine between their normals is greater than kParallel, and their planes' distances from
// the origin differ by less than kSamePlane median ray lengths.
constexpr float kParallel = 0.999f, kSamePlane = 0.01f;
constexpr size_t kMostPlanes = 40;
constexpr double kFewestHits = 0.002;  // in a plane, as a share of all hits
constexpr int kCells = 48;             // along a side of a wall

struct Leaving {
    Vec3 o, d;
};
struct Spot {
    Vec3 p, n;  // n: unit normal on the side that the ray came from
};
struct Sightings {
    std::vector<Leaving> leaving;
    std::vector<Spot> spots;
    std::vector<float> lengths;
};

std::optional<Spot> look(const Accel& accel, Ray ray, Sightings& seen) {
    SurfaceInteraction hit;
    const Vec3 o = ray.o;
    const Arrival arrival = toSurface(accel, ray, hit, [](const SurfaceInteraction&) {});
    if (arrival == Arrival::Escaped) seen.leaving.push_back({o, ray.d});
    if (arrival != Arrival::Surface) return {};
    const Spot spot{hit.p, faceForward(hit.ng, hit.wo)};
    seen.spots.push_back(spot);
    seen.lengths.push_back(length(hit.p - o));
    return spot;
}

// Traces the view rays, diffuse rays from the surfaces that they hit, and diffuse rays from the surfaces that those
// hit.
Sightings lookAround(const Accel& accel, std::span<const Ray> views) {
    constexpr int kGrain = 64;
    std::vector<Sightings> parts((views.size() + kGrain - 1) / kGrain);
    parallelFor(0, int(views.size()), kGrain, [&](int begin, int end) {
        Sightings& seen = parts[size_t(begin / kGrain)];
        for (int i = begin; i < end; ++i) {
            Pcg32 rng(hashCombine(kStream, uint64_t(i)));
            const auto diffuse = [&](const Spot& from) {
                Ray ray;
                ray.d = Frame::fromNormal(from.n).toWorld(sampleCosineHemisphere(rng.nextVec2()));
                ray.o = SpawnPoint{from.p, from.n, 0, roundingError(from.p)}.towards(ray.d);
                ray.time = views[size_t(i)].time;
                return look(accel, ray, seen);
            };
            const auto first = look(accel, views[size_t(i)], seen);
            for (int k = 0; first && k < kFirstRays; ++k) {
                const auto second = diffuse(*first);
                for (int j = 0; second && j < kSecondRays; ++j) diffuse(*second);
            }
        }
    });
    Sightings all;
    for (const Sightings& part : parts) {
        all.leaving.insert(all.leaving.end(), part.leaving.begin(), part.leaving.end());
        all.spots.insert(all.spots.end(), part.spots.begin(), part.spots.end());
        all.lengths.insert(all.lengths.end(), part.lengths.begin(), part.lengths.end());
    }
    return all;
}

// A wall: the plane dot(n, p) = offset, with n towards the room, and the extent of its hits along the frame's s and t.
struct Wall {
    Vec3 n;
    float offset = 0;
    size_t hits = 0;
    Vec3 first{0.f};  // position of the first hit
    Frame frame{};
    std::vector<Vec2> places{};  // the hits, along s and t
    Vec2 low{kInfinity}, high{-kInfinity};

    void extend(const Vec2& q) {
        low = Vec2(std::min(low.x, q.x), std::min(low.y, q.y));
        high = Vec2(std::max(high.x, q.x), std::max(high.y, q.y));
    }

    Vec2 at(const Vec3& p) const { return Vec2(dot(p, frame.s), dot(p, frame.t)); }
    bool holds(const Spot& spot, float tolerance) const {
        return dot(spot.n, n) > kParallel && std::abs(dot(spot.p, n) - offset) < tolerance;
    }
    // Where a ray that leaves crosses the plane from the room's side, along s and t, if within the extent.
    std::optional<Vec2> left(const Leaving& ray, float tolerance) const {
        const float towards = dot(ray.d, n), distance = dot(ray.o, n) - offset;
        if (!(towards < 0 && distance > tolerance)) return {};
        const Vec2 q = at(ray.o - ray.d * (distance / towards));
        if (!(q.x >= low.x && q.x <= high.x && q.y >= low.y && q.y <= high.y)) return {};
        return q;
    }
};

// The planes with the most hits.
std::vector<Wall> planesOf(const std::vector<Spot>& spots, float tolerance) {
    // Hits are counted by rounded normal and offset. Rounding may divide a wall; the loop below merges the parts, by
    // testing the first hit of each part against the walls found so far.
    std::map<std::array<int, 4>, Wall> cells;
    for (const Spot& spot : spots) {
        constexpr float kNormals = 16;
        const float offset = dot(spot.p, spot.n);
        const auto rounded = [](float x) { return int(std::lround(std::clamp(x, -1e8f, 1e8f))); };
        const std::array<int, 4> key = {rounded(kNormals * spot.n.x), rounded(kNormals * spot.n.y),
                                        rounded(kNormals * spot.n.z), rounded(0.5f * offset / tolerance)};
        Wall& wall = cells[key];
        if (wall.hits++ > 0) continue;
        wall.n = spot.n;
        wall.offset = offset;
        wall.first = spot.p;
    }
    std::vector<Wall> all, walls;
    for (const auto& [key, wall] : cells)
        if (double(wall.hits) >= kFewestHits * double(spots.size())) all.push_back(wall);
    std::ranges::stable_sort(all, std::greater(), &Wall::hits);
    for (const Wall& wall : all) {
        const bool isKnown = std::ranges::any_of(walls, [&](const Wall& w) {
            return w.holds({wall.first, wall.n}, tolerance);
        });
        if (!isKnown && walls.size() < kMostPlanes) walls.push_back(wall);
    }
    return walls;
}

// planesOf() plus the sides of the bounding box of all hits, where a room may be open.
std::vector<Wall> wallsOf(const std::vector<Spot>& spots, float tolerance) {
    std::vector<Wall> walls = planesOf(spots, tolerance);
    // Frames are aligned with the edge to a perpendicular wall, because windows are parallel to such edges.
    for (Wall& wall : walls) {
        const auto other =
            std::ranges::find_if(walls, [&](const Wall& w) { return std::abs(dot(w.n, wall.n)) < 0.1f; });
        wall.frame = other != walls.end() ? Frame::fromNormalAndTangent(wall.n, cross(wall.n, other->n))
                                          : Frame::fromNormal(wall.n);
    }
    Bounds box;
    for (const Spot& spot : spots) {
        box.extend(spot.p);
        for (Wall& wall : walls) {
            if (!wall.holds(spot, tolerance)) continue;
            wall.places.push_back(wall.at(spot.p));
            wall.extend(wall.places.back());
        }
    }
    for (int side = 0; side < 6 && !box.empty(); ++side) {
        Wall wall;
        wall.n = Vec3(0.f);
        wall.n[side / 2] = side % 2 ? -1.f : 1.f;
        wall.frame = Frame::fromNormal(wall.n);
        wall.offset = dot(side % 2 ? box.max : box.min, wall.n);
        for (const Vec3& corner : {box.min, box.max}) wall.extend(wall.at(corner));
        walls.push_back(wall);
    }
    return walls;
}

struct Opening {
    Vec2 low{kInfinity}, high{-kInfinity};
    size_t rays = 0;
    float area() const { return (high.x - low.x) * (high.y - low.y); }
    // Small openings that many rays pass come first.
    float worth() const { return rays >= kFewestRays && area() > 0 ? float(rays) / std::sqrt(area()) : 0; }
    bool holds(const Vec2& q) const { return q.x >= low.x && q.x <= high.x && q.y >= low.y && q.y <= high.y; }
};

// The best opening of a wall: a connected part of its plane that more rays pass through than hit.
std::optional<Opening> openingOf(const Wall& wall, const std::vector<Leaving>& leaving, float tolerance) {
    const Vec2 size = wall.high - wall.low;
    if (!(size.x > 0 && size.y > 0)) return {};
    const auto cellOf = [&](const Vec2& q) {
        const auto along = [](float x, float low, float extent) {
            return std::clamp(int((x - low) / extent * kCells), 0, kCells - 1);
        };
        return size_t(along(q.y, wall.low.y, size.y) * kCells + along(q.x, wall.low.x, size.x));
    };
    std::array<int, kCells * kCells> balance{};  // rays that pass, less those that hit
    std::vector<Vec2> passed;
    for (const Leaving& ray : leaving)
        if (const auto q = wall.left(ray, tolerance)) {
            passed.push_back(*q);
            ++balance[cellOf(*q)];
        }
    if (passed.size() < kFewestRays) return {};
    for (const Vec2& hit : wall.places) --balance[cellOf(hit)];
    // Finds connected parts by flood filling.
    std::array<int, kCells * kCells> part{};
    std::vector<Opening> openings(1);
    for (int start = 0; start < kCells * kCells; ++start) {
        if (balance[size_t(start)] <= 0 || part[size_t(start)] != 0) continue;
        std::vector<int> open = {start};
        part[size_t(start)] = int(openings.size());
        while (!open.empty()) {
            const int cell = open.back();
            open.pop_back();
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const int x = cell % kCells + dx, y = cell / kCells + dy, next = y * kCells + x;
                    if (x < 0 || y < 0 || x >= kCells || y >= kCells) continue;
                    if (balance[size_t(next)] <= 0 || part[size_t(next)] != 0) continue;
                    part[size_t(next)] = int(openings.size());
                    open.push_back(next);
                }
        }
        openings.emplace_back();
    }
    for (const Vec2& q : passed) {
        Opening& opening = openings[size_t(part[cellOf(q)])];
        opening.low = Vec2(std::min(opening.low.x, q.x), std::min(opening.low.y, q.y));
        opening.high = Vec2(std::max(opening.high.x, q.x), std::max(opening.high.y, q.y));
        ++opening.rays;
    }
    openings.front().rays = 0;  // part 0: places outside all openings
    const auto best = std::ranges::max_element(openings, {}, &Opening::worth);
    if (!(best->worth() > 0)) return {};
    // The outermost of n uniform points are on average 1 / (n + 1) of the width off the edges.
    const Vec2 margin = (best->high - best->low) * (1.5f / float(best->rays) + 0.005f);
    best->low -= margin;
    best->high += margin;
    return *best;
}

Portal portalOf(const Wall& wall, const Opening& opening) {
    const auto at = [&](float x, float y) { return wall.frame.s * x + wall.frame.t * y + wall.n * wall.offset; };
    // Outward is against the wall's normal: cross(corner 3 - corner 0, corner 1 - corner 0) = cross(t, s) = -n.
    return Portal({at(opening.low.x, opening.low.y), at(opening.high.x, opening.low.y),
                   at(opening.high.x, opening.high.y), at(opening.low.x, opening.high.y)});
}

const Spot& anyOf(const std::vector<Spot>& spots, Pcg32& rng) {
    return spots[std::min(spots.size() - 1, size_t(rng.nextFloat() * float(spots.size())))];
}

// Whether a ray from a surface leaves the scene.
bool leaves(const Accel& accel, const Spot& from, const Vec3& d) {
    Ray ray;
    ray.o = SpawnPoint{from.p, from.n, 0, roundingError(from.p)}.towards(d);
    ray.d = d;
    SurfaceInteraction hit;
    return toSurface(accel, ray, hit, [](const SurfaceInteraction&) {}) == Arrival::Escaped;
}

// Share of light samples in a window that arrive unoccluded, over random surface points, weighted by the irradiance
// that the window could bring.
double arrivalThrough(const Portal& window, const Accel& accel, const std::vector<Spot>& spots) {
    LightReach reach{{}, -window.outward()};
    for (const Vec3& corner : window.corners()) reach.bounds.extend(corner);
    reach.spread = 0;
    reach.intensity = window.area();
    const LightBound bound(reach);
    Pcg32 rng(kStream);
    double arrived = 0, all = 0;
    for (int i = 0; i < kTrials; ++i) {
        const Spot& spot = anyOf(spots, rng);
        const Vec3 d = normalize(window.pointAt(rng.nextVec2()) - spot.p);
        const float weight = window.windowFrom(spot.p) ? bound.irradiance(spot.p) : 0;
        if (!(dot(d, spot.n) > 0 && weight > 0 && std::isfinite(weight))) continue;
        all += double(weight);
        if (leaves(accel, spot, d)) arrived += double(weight);
    }
    return all > 0 ? arrived / all : 0;
}

std::vector<Portal> windowsIn(const Accel& accel, Sightings seen) {
    const double leaving = double(seen.leaving.size()), all = leaving + double(seen.spots.size());
    if (leaving < double(kFewestRays) || leaving < kFewestLeave * all || leaving > kMostLeave * all) return {};
    const auto median = seen.lengths.begin() + std::ptrdiff_t(seen.lengths.size() / 2);
    std::nth_element(seen.lengths.begin(), median, seen.lengths.end());
    const float tolerance = kSamePlane * *median, largest = kLargest * sqr(*median);
    if (!(tolerance > 0 && std::isfinite(largest))) return {};
    const std::vector<Wall> walls = wallsOf(seen.spots, tolerance);

    std::vector<Portal> windows;
    double explained = 0;
    for (size_t tried = 0; tried < 2 * kMostWindows && windows.size() < kMostWindows; ++tried) {
        const Wall* in = nullptr;
        Opening best;
        for (const Wall& wall : walls) {
            const auto opening = openingOf(wall, seen.leaving, tolerance);
            if (!opening || double(opening->rays) < kExplainedByOne * leaving) continue;
            if (in != nullptr && !(opening->worth() > best.worth())) continue;
            in = &wall;
            best = *opening;
        }
        if (in == nullptr) break;
        const Portal window = portalOf(*in, best);
        const bool helps = window.area() < largest && arrivalThrough(window, accel, seen.spots) > kFewestArrive;
        if (helps) windows.push_back(window);
        const size_t before = seen.leaving.size();
        std::erase_if(seen.leaving, [&](const Leaving& ray) {
            const auto q = in->left(ray, tolerance);
            return q && best.holds(*q);
        });
        if (helps) explained += double(before - seen.leaving.size());
    }
    if (explained < kExplainedTogether * leaving) return {};
    return windows;
}

// Efficiency of irradiance samples at these surfaces: the square of their mean over their mean square, 1 without any
// noise.
double efficiency(const EnvironmentWindows& windows, const Accel& accel, const std::vector<Spot>& spots) {
    Pcg32 rng(kStream);
    double sum = 0, squares = 0;
    for (int i = 0; i < kTrialsOfAll; ++i) {
        const Spot& spot = anyOf(spots, rng);
        const auto s = windows.sample(spot.p, rng.nextVec2());
        const float cosine = s ? dot(s->wi, spot.n) : 0;
        if (!(cosine > 0 && s->pdf > 0 && leaves(accel, spot, s->wi))) continue;
        const double value = double(luminance(windows.environment().escaped(spot.p, s->wi)) * cosine / s->pdf);
        sum += value;
        squares += value * value;
    }
    return squares > 0 ? sum * sum / (squares * kTrialsOfAll) : 0;
}

}  // namespace

std::vector<Portal> findWindows(const Accel& accel, std::span<const Ray> views) {
    return windowsIn(accel, lookAround(accel, views));
}

EnvironmentWindows windowsOnto(const Light& environment, const Accel& accel, std::span<const Ray> views) {
    const Sightings seen = lookAround(accel, views);
    const EnvironmentWindows none(environment), found(environment, windowsIn(accel, seen));
    if (found.count() == 0) return none;
    return efficiency(found, accel, seen.spots) > kGain * efficiency(none, accel, seen.spots) ? found : none;
}

}  // namespace drc
