#include "image/surface_match.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "image/image_layers.h"
#include "image/picture_window.h"

namespace drc {
namespace {

// A pixel shows the same surface if the cosine between both normals is at least this, and if its point is off the
// surface's plane by at most this share of the distance from the camera.
constexpr float kLeastNormalCosine = 0.9f, kOffPlane = 0.005f;
// Albedos whose ratio is beyond this are of different things. kLeastAlbedo keeps ratios of dark ones near 1.
constexpr float kMostAlbedoRatio = 3, kLeastAlbedo = 0.02f;
// A point counts as shown if pixels with this share of its interpolation show it.
constexpr float kLeastSeen = 0.4f;

Vec3 vectorAt(const Image& image, int x, int y) {
    const float* p = image.pixel(x, y);
    return {p[0], p[1], p[2]};
}

// Whether each pixel or one of its eight neighbours lies where a surface meets a lamp or the sky, which have no albedo
// and may be a thousand times as bright.
std::vector<uint8_t> silhouettesOf(const FrameSurfaces& frame) {
    const int width = frame.albedo.width(), height = frame.albedo.height();
    const auto shines = [&](int x, int y) {
        const Rgb albedo = frame.albedo.rgb(x, y);
        return std::max({albedo.x, albedo.y, albedo.z}) < kLeastAlbedo;
    };
    std::vector<uint8_t> at(frame.albedo.pixelCount());
    parallelFor(0, height, 8, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < width; ++x) {
                bool any = false, all = true;
                for (int oy = std::max(0, y - 1); oy <= std::min(height - 1, y + 1); ++oy)
                    for (int ox = std::max(0, x - 1); ox <= std::min(width - 1, x + 1); ++ox)
                        shines(ox, oy) ? any = true : all = false;
                at[size_t(y) * size_t(width) + size_t(x)] = any && !all;
            }
    });
    return at;
}

}  // namespace

SurfaceMatch::SurfaceMatch(const FrameSurfaces& now, const FrameSurfaces& other)
    : now_(now),
      other_(other),
      film_{now.window.fullWidth > 0 ? now.window.fullWidth : now.albedo.width(),
            now.window.fullHeight > 0 ? now.window.fullHeight : now.albedo.height()},
      sameCamera_(now.geometry.worldToNdc == other.geometry.worldToNdc) {
    requireSamePlace({now.name, now.albedo, now.window}, {other.name, other.albedo, other.window},
                     "followed from one frame to another");
    for (const float object : now.object.data()) {
        const auto [entry, isNew] = motions_.try_emplace(uint32_t(object));
        if (!isNew) continue;
        const Transform here = now.geometry.objects.of(entry->first), there = other.geometry.objects.of(entry->first);
        entry->second.moves = here.isInvertible() && !(here == there);
        if (entry->second.moves) entry->second.toOther = there * here.inverse();
    }
    silhouettes_ = silhouettesOf(now);
    itsSilhouettes_ = silhouettesOf(other);
}

const MatchedPixels::Pixel* SurfaceMatch::nearest(int x, int y, const MatchedPixels& match) const {
    constexpr float kVeryPlace = 1 / 8.f;
    if (match.count == 0) return nullptr;
    const auto first = match.pixels.begin();
    const MatchedPixels::Pixel& pixel =
        *std::max_element(first, first + match.count, [](const auto& p, const auto& q) { return p.weight < q.weight; });
    const auto width = size_t(now_.albedo.width());
    const bool isSilhouette = silhouettes_[size_t(y) * width + size_t(x)] != 0 ||
                              itsSilhouettes_[size_t(pixel.y) * width + size_t(pixel.x)] != 0;
    const float off = std::max(std::abs(match.place.x - float(pixel.x)), std::abs(match.place.y - float(pixel.y)));
    return isSilhouette && off > kVeryPlace ? nullptr : &pixel;
}

float SurfaceMatch::albedoRatio(int x, int y, const MatchedPixels::Pixel& pixel, int c) const {
    return (now_.albedo.at(x, y, c) + kLeastAlbedo) / (other_.albedo.at(pixel.x, pixel.y, c) + kLeastAlbedo);
}

bool SurfaceMatch::showsSame(int ox, int oy, int x, int y, const Vec3& there, const Vec3& normal) const {
    if (ox < 0 || oy < 0 || ox >= other_.albedo.width() || oy >= other_.albedo.height()) return false;
    if (other_.object.at(ox, oy, 0) != now_.object.at(x, y, 0)) return false;
    const float depth = other_.depth.at(ox, oy, 0);
    if (!(depth < kNoDepth)) return false;
    const Vec3 its = vectorAt(other_.normal, ox, oy);
    const float lengths = length(its) * length(normal);
    if (lengths > 0) {
        if (dot(its, normal) < kLeastNormalCosine * lengths) return false;
        const float off = std::abs(dot(normal, vectorAt(other_.position, ox, oy) - there)) / length(normal);
        if (off > kOffPlane * std::abs(depth)) return false;
    }
    for (int c = 0; c < 3; ++c) {
        const float ratio = albedoRatio(x, y, {ox, oy, 1}, c);
        if (ratio > kMostAlbedoRatio || ratio < 1 / kMostAlbedoRatio) return false;
    }
    return true;
}

MatchedPixels SurfaceMatch::at(int x, int y) const {
    MatchedPixels match;
    if (!(now_.depth.at(x, y, 0) < kNoDepth)) {
        if (!sameCamera_ || other_.depth.at(x, y, 0) < kNoDepth) return match;
        match.pixels[0] = {x, y, 1};
        match.place = Vec2(float(x), float(y));
        match.count = 1;
        match.seen = 1;
        return match;
    }
    const Motion& motion = motions_.at(uint32_t(now_.object.at(x, y, 0)));
    const Vec3 here = vectorAt(now_.position, x, y), facing = vectorAt(now_.normal, x, y);
    const Vec3 there = motion.moves ? motion.toOther.point(here) : here;
    const Vec3 normal = motion.moves ? motion.toOther.normal(facing) : facing;
    const auto from = pixelOf(here, now_.geometry, film_), to = pixelOf(there, other_.geometry, film_);
    if (!from || !to) return match;
    // The mean of a pixel's points need not lie at its centre, to which the motion applies.
    const float px = float(x) + to->x - from->x, py = float(y) + to->y - from->y;
    constexpr float kFar = 1e6f;
    if (!(std::abs(px) < kFar && std::abs(py) < kFar)) return match;
    match.place = Vec2(px, py);
    const int x0 = int(std::floor(px)), y0 = int(std::floor(py));
    const float fx = px - float(x0), fy = py - float(y0);
    for (int dy = 0; dy < 2; ++dy)
        for (int dx = 0; dx < 2; ++dx) {
            const float share = (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy);
            if (share < 1e-3f || !showsSame(x0 + dx, y0 + dy, x, y, there, normal)) continue;
            match.pixels[size_t(match.count++)] = {x0 + dx, y0 + dy, share};
            match.seen += share;
        }
    if (match.seen < kLeastSeen) return {};
    for (int i = 0; i < match.count; ++i) match.pixels[size_t(i)].weight /= match.seen;
    match.seen = std::min(1.f, match.seen);
    return match;
}

}  // namespace drc
