// One object per thread, for objects that are too expensive to make for every piece of a loop, such as a network's
// buffers.
#pragma once
#include <tbb/enumerable_thread_specific.h>

#include "base/parallel.h"

namespace drc {

template <typename T>
class PerThread {
  public:
    // make: callable that returns a T; called when a thread first needs one.
    template <typename Make>
    explicit PerThread(Make make) : things_(std::move(make)) {}

    // Calls body(T&) with the calling thread's T. The body may run parallel loops, its own or a library's on oneTBB: it
    // runs isolated(), so that no other piece of work uses the same T in the meantime.
    template <typename Body>
    void use(const Body& body) {
        isolated([&] { body(things_.local()); });
    }

  private:
    tbb::enumerable_thread_specific<T> things_;
};

}  // namespace drc
