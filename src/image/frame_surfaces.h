// The surfaces that a frame of an animation shows, as drc render --aovs writes them.
#pragma once
#include <string>

#include "image/frame_geometry.h"
#include "image/image.h"

namespace drc {

// All images have the same size.
struct FrameSurfaces {
    std::string name;               // of the file, for messages
    Image albedo, normal;           // layers Denoising Albedo and Denoising Normal
    Image position, depth, object;  // layers Position, Depth and IndexOB
    FrameGeometry geometry;         // with worldToNdc
    ExrWindow window;
};

// Throws Error, naming the file, if a layer or the camera's matrix is missing.
FrameSurfaces frameSurfacesOf(const PictureFile& picture);
// A layer of such a file, with NaN and infinity as zero. Throws Error, naming the file, if it is missing.
Image layerOverTime(const PictureFile& picture, const std::string& layer);

}  // namespace drc
