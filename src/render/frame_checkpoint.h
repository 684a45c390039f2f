// Checkpoints of animations: what tells a frame's state from that of another frame.
#pragma once
#include <optional>
#include <string>

#include "render/checkpoint.h"

namespace drc {

// A frame of an animation, counted from 1: that of the command line.
struct FramePosition {
    int frame = 1;
    int loaded = 1;  // the frame whose scene was loaded; those since then have moved its camera
};

// Identifies the state of this frame, in addition to its scene. file: the frame's scene file. Throws Error if it cannot
// be read.
Identity frameIdentity(const FramePosition& position, const std::string& file);

// The frame that a checkpoint is of; none if it is not of an animation. Throws Error if the file cannot be read or is
// no checkpoint.
std::optional<FramePosition> framePositionIn(const std::string& path);

}  // namespace drc
