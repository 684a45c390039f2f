// Renews the answers of radiance cells after deposits have been added. A cell with too few deposits, or whose mean
// would be too noisy, gets the answer of a larger cell around it, so that most look-ups read one cell.
#pragma once
#include "cells/cell_statistics.h"

namespace drc {

struct CellAnswerSettings {
    int deposits = 16;  // deposits that a cell needs before it answers
    // Cells smaller than the largest size are used if the relative variance of their mean is at most this.
    float variance = 0.1f;
};

// Statistics over all cells together.
struct CellTotals {
    size_t used = 0;  // number of cells in use
    double mean = 0;  // mean over all deposits of luminance per view factor, of the cells that they are in
    // The mean of the answers' relative standard errors, weighted by deposits. any: whether there are deposits.
    double error = 0;
    bool any = false;
};

CellTotals renewCellAnswers(CellTable& table, const CellGrid& grid, const CellStatistics& statistics,
                            const CellAnswerSettings& settings);

}  // namespace drc
