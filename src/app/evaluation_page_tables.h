// The tables of an evaluation's page, as HTML for htmlPage: one column for each measure, one block for each statistic
// or pair of methods.
#pragma once
#include <string>

#include "app/evaluation_report.h"

namespace drc {

// Means, medians and quartiles of each method; the best mean and median are marked.
std::string scoreTable(const GroupReport& group);

// The Kruskal-Wallis test of all methods, then each pair: how often the first is better, and both tests.
std::string testTable(const GroupReport& group);

// The pairs of testTable() across two groups, with the means over the viewpoints that both groups have.
std::string acrossTable(const AcrossReport& across, const std::string& firstGroup, const std::string& secondGroup);

}  // namespace drc
