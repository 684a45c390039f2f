// The engine for every use of oneDNN here, and the promise that a call stays on the calling thread.
#pragma once
#include <array>
#include <dnnl.hpp>

namespace drc {

// The one CPU engine; memory and primitives of different engines do not mix.
const dnnl::engine& cpuEngine();

// While it lives, OpenMP regions of the calling thread (oneDNN's, under Debian's build) run on this thread alone. The
// renderer runs one network a thread: a team of OpenMP threads in each would wait for each other in spin barriers.
// oneDNN plans for the number of threads it sees when a primitive is made, so that making one needs this as well.
class SingleThreadScope {
  public:
    SingleThreadScope();
    ~SingleThreadScope();
    SingleThreadScope(const SingleThreadScope&) = delete;
    SingleThreadScope& operator=(const SingleThreadScope&) = delete;

  private:
    std::array<int, 2> previous_{};  // of each OpenMP library that may be oneDNN's; 0: none
};

}  // namespace drc
