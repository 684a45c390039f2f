// Trains radiance cells over the cameras of a shot, for a file that its frames read.
#pragma once
#include <functional>

#include "render/session.h"

namespace drc {

struct CellTraining {
    static constexpr int kMostParts = 1000;

    double seconds = 0;      // wall-clock budget; 0: none
    std::optional<int> spp;  // camera samples a pixel at each camera; with a budget, at most
    // The part of a training that several processes share, from 0 to kMostParts - 1: each takes other samples.
    int part = 0;
    const CancelToken* cancel = nullptr;
    // Called after each camera. share: part of the work that is done, in [0, 1]. error: RadianceCells::error().
    std::function<void(double share, double error)> visited;
};

// Visits the cameras in turn, a sample of each pixel at a time, until the budget or the samples are used up; without
// either, until the mean standard error of the cells hardly falls any more. The films are small, because cells need
// many paths and no picture. Their size follows from the median of the distances that the cameras show, if params leave
// it open. params: resolved, of an integrator with cells. sensors: at least one. Parts of one training add up
// (CellCollection::add). Throws Error if there is nothing that cells could be of.
CellCollection trainCells(const Scene& scene, const std::vector<Sensor>& sensors, RenderParams params,
                          const CellTraining& training);

}  // namespace drc
