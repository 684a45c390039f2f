// Checkpoints of animations: the part of their identity that distinguishes frames.
#pragma once
#include <optional>
#include <string>

#include "render/checkpoint.h"

namespace drc {

// A frame of an animation, counted from 1, which is the frame of the command line.
struct FramePosition {
    int frame = 1;
    int loaded = 1;  // the frame whose scene was loaded; later frames have only moved its camera
};

// The identity of this frame's state, without that of its scene. file: the frame's scene file. Throws Error if the file
// cannot be read.
Identity frameIdentity(const FramePosition& position, const std::string& file);

// The frame whose state a checkpoint contains; none if it is not of an animation. Throws Error if the file cannot be
// read or is no checkpoint.
std::optional<FramePosition> framePositionIn(const std::string& path);

}  // namespace drc
