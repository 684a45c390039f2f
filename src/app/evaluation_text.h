// An evaluation as text for people and as JSON for programs. Both are grouped by the projection of the maps.
#pragma once
#include <string>

#include "app/evaluation_report.h"
#include "app/evaluation_samples.h"

namespace drc {

// Several tables, ready to print.
std::string evaluationTable(const Evaluation& evaluation, const EvaluationReport& report);

// One object on one line. NaN is written as null; a p of kSmallestP beside `"p_is_bound": true` is an upper bound. With
// `samples` it also has examples, whose pictures are written.
std::string evaluationJson(const Evaluation& evaluation, const EvaluationReport& report,
                           const SampleSettings* samples = nullptr);

// "equal-area maps of 32x32 texels, 494 examples of 25 files, one input each"
std::string describeGroup(const EvaluatedGroup& group);

}  // namespace drc
