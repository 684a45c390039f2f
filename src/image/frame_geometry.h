// How a frame of an animation shows its world: the camera, and where the objects are. EXR files of `drc render` have it
// as attributes.
#pragma once
#include <optional>

#include "image/object_placements.h"
#include "image/picture_file.h"

namespace drc {

// World space is that of the scene file, at the opening of the shutter. camera_matrices.h tells the spaces of the two
// matrices, which here act on column vectors.
struct FrameGeometry {
    Transform worldToCamera;
    std::optional<Transform> worldToNdc;  // none if no matrix tells where the camera shows a point
    ObjectPlacements objects;
};

// OpenEXR's standard attributes.
inline constexpr const char *kWorldToCamera = "worldToCamera", *kWorldToNdc = "worldToNDC";
// The number of the frame in its animation, a string of digits.
inline constexpr const char* kFrameNumber = "drc:frame";

ExrAttributes attributesOf(const FrameGeometry& geometry);
// None if the file does not have the camera's place. Throws Error, naming the file, if it is damaged.
std::optional<FrameGeometry> frameGeometryIn(const PictureFile& picture);
// 0 if the file does not tell it, or if it is a still.
int frameNumberIn(const ExrMetadata& metadata);

}  // namespace drc
