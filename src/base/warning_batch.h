// Says the same warning once, however many places of a file it is true of, and how many those are.
#pragma once

namespace drc {

// While one lives, warnings are kept back. At its end each message is printed once, in the order in which they came
// first, with the first of its places and, if there are more, "(and 129 more)". Inner batches add to the outermost.
class WarningBatch {
  public:
    WarningBatch();
    ~WarningBatch();
    WarningBatch(const WarningBatch&) = delete;
    WarningBatch& operator=(const WarningBatch&) = delete;
};

}  // namespace drc
