// Renews what radiance cells answer after deposits have been added. A cell that knows too little itself, or whose
// neighbours are as good a guess, has the answer of a larger cell around it, so that most look-ups read one cell.
#pragma once
#include "cells/cell_statistics.h"

namespace drc {

struct CellAnswerSettings {
    int deposits = 16;  // that a cell needs before it answers
    // The relative variance of a mean up to which cells are used that are not of the largest size.
    float variance = 0.1f;
};

// Statistics over all cells together.
struct CellTotals {
    size_t used = 0;  // cells
    double mean = 0;  // of all deposits' luminance, divided by the view factor's
    // The mean of the answers' relative standard errors, weighted by deposits; none: there is no deposit.
    double error = 0;
    bool any = false;
};

CellTotals renewCellAnswers(CellTable& table, const CellGrid& grid, const CellStatistics& statistics,
                            const CellAnswerSettings& settings);

}  // namespace drc
