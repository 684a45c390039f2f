// How far the points that a frame shows move in the picture from one frame to another: Blender's layer "Vector".
#pragma once
#include "image/frame_geometry.h"

namespace drc {

// The size of the whole picture (of an EXR's display window), in pixels.
struct FilmSize {
    int width, height;
};

// The point of the other frame that is now at `position`: both in world space, which for objects that stand still is
// the same point. object: of the layer IndexOB. Deformations, which no matrix of the object tells, are not followed.
Vec3 pointInFrame(const Vec3& position, uint32_t object, const FrameGeometry& now, const FrameGeometry& other);

// The place of a point of world space in a frame's picture, in pixels from the upper left corner of the whole, y down.
// None if the point is not in front of the camera, or if the camera has no matrix.
std::optional<Vec2> pixelOf(const Vec3& position, const FrameGeometry& frame, const FilmSize& film);

// Layer "Vector" with the channels X, Y, Z, W as Blender's Cycles writes it, in pixels, x to the right and y up:
// X and Y are the place in the previous frame minus that in this frame, Z and W the place in this frame minus that in
// the next. Zero where the picture shows nothing, where a place is not known, and for a frame that is null.
// position (X, Y, Z), depth (Z) and object (X): the layers Position, Depth and IndexOB of this frame.
Image motionVectors(const Image& position, const Image& depth, const Image& object, const FrameGeometry& now,
                    const FrameGeometry* previous, const FrameGeometry* next, const FilmSize& film);

}  // namespace drc
