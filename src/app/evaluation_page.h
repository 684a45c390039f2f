// The page of `drc evaluate --html`: one file with tables, box plots, tests and pictures of some examples.
#pragma once
#include <string>

#include "app/evaluation_report.h"

namespace drc {

struct PageSamples {
    size_t count = 12;  // examples of each projection that are shown (chooseExamples)
    uint64_t seed = 0;
};

// Throws Error, as ExampleSource::load does, if a file of examples is no longer what it was.
std::string evaluationPage(const Evaluation& evaluation, const EvaluationReport& report, const PageSamples& samples);

}  // namespace drc
