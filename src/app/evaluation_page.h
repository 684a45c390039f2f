// The page of `drc evaluate --html`: one file with tables, box plots, tests and pictures of some examples.
#pragma once
#include <string>

#include "app/evaluation_report.h"

namespace drc {

struct PageSamples {
    size_t count = 12;  // number of examples shown for each projection (chooseExamples)
    uint64_t seed = 0;
};

// Throws Error, as ExampleSource::load does, if a file of examples has changed since it was opened.
std::string evaluationPage(const Evaluation& evaluation, const EvaluationReport& report, const PageSamples& samples);

}  // namespace drc
