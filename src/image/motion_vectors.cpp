#include "image/motion_vectors.h"

#include "image/image_layers.h"

namespace drc {

Vec3 pointInFrame(const Vec3& position, uint32_t object, const FrameGeometry& now, const FrameGeometry& other) {
    const Transform here = now.objects.of(object), there = other.objects.of(object);
    if (here == there || !here.isInvertible()) return position;
    return (there * here.inverse()).point(position);
}

std::optional<Vec2> pixelOf(const Vec3& position, const FrameGeometry& frame, const FilmSize& film) {
    if (!frame.worldToNdc || !(frame.worldToCamera.point(position).z > 0)) return {};
    const Vec3 ndc = frame.worldToNdc->point(position);
    return Vec2(ndc.x * float(film.width), ndc.y * float(film.height));
}

Image motionVectors(const Image& position, const Image& depth, const Image& object, const FrameGeometry& now,
                    const FrameGeometry* previous, const FrameGeometry* next, const FilmSize& film) {
    Image vectors(position.width(), position.height(), {"X", "Y", "Z", "W"});
    for (int y = 0; y < vectors.height(); ++y)
        for (int x = 0; x < vectors.width(); ++x) {
            if (!(depth.at(x, y, 0) < kNoDepth)) continue;
            const Vec3 point(position.at(x, y, 0), position.at(x, y, 1), position.at(x, y, 2));
            const auto index = uint32_t(object.at(x, y, 0));
            const std::optional<Vec2> here = pixelOf(point, now, film);
            // sign: +1 for the way to the other frame, -1 for the way from it.
            const auto set = [&](const FrameGeometry* other, int channel, float sign) {
                if (other == nullptr || !here) return;
                const auto there = pixelOf(pointInFrame(point, index, now, *other), *other, film);
                if (!there) return;
                vectors.at(x, y, channel) = sign * (there->x - here->x);
                vectors.at(x, y, channel + 1) = sign * (here->y - there->y);
            };
            set(previous, 0, 1);
            set(next, 2, -1);
        }
    return vectors;
}

}  // namespace drc
