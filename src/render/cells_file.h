// Radiance cells of a scene in a file of their own: trained over the cameras of a shot, merged, and read by each of its
// frames on any machine.
#pragma once
#include "cells/cell_collection.h"
#include "integrators/render_params.h"
#include "render/identity.h"

namespace drc {

// Identifies what cells hold the light of: the scene without its camera and film, and the settings of paths. params:
// resolved. Throws Error if the scene came through a pipe, or if its world depends on the camera (CoordSysTransform).
Identity cellsIdentity(const Scene& scene, const RenderParams& params);

void saveCells(const std::string& path, const CellCollection& cells, const Identity& identity);
// what: names the file in messages, as "--cells shot.cells". Throws Error, in one line, if the file is of another
// identity (which difference there is), damaged, or of a later version of the format.
CellCollection loadCells(const std::string& what, const std::string& path, const Identity& identity);
// The identity of a file of cells. Throws Error as loadCells().
Identity identityOfCells(const std::string& what, const std::string& path);

}  // namespace drc
