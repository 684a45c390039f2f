// The oneDNN engine that all networks share, and a scope that keeps oneDNN's work on the calling thread.
#pragma once
#include <array>
#include <dnnl.hpp>

namespace drc {

// The only CPU engine, because memory and primitives of different engines cannot be mixed.
const dnnl::engine& cpuEngine();

// While an object of this class exists, OpenMP regions of the calling thread (oneDNN uses them in Debian's build) run
// on this thread alone. The renderer runs one network per thread; with a team of OpenMP threads for each, the teams
// would wait for each other in spin barriers. Creating a primitive needs this scope too, because oneDNN then plans for
// the number of threads that it sees.
class SingleThreadScope {
  public:
    SingleThreadScope();
    ~SingleThreadScope();
    SingleThreadScope(const SingleThreadScope&) = delete;
    SingleThreadScope& operator=(const SingleThreadScope&) = delete;

  private:
    // For each library that may be oneDNN's, its number of threads before; 0: no such library.
    std::array<int, 2> previous_{};
};

}  // namespace drc
