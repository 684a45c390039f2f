// Prints identical warnings about a file once, with the number of their locations.
#pragma once

namespace drc {

// Holds back warnings during its lifetime. The destructor prints each message once, in the order of first occurrence,
// with the first location and, if there are more, "(and 129 more)". Inner batches add to the outermost one.
class WarningBatch {
  public:
    WarningBatch();
    ~WarningBatch();
    WarningBatch(const WarningBatch&) = delete;
    WarningBatch& operator=(const WarningBatch&) = delete;
};

}  // namespace drc
