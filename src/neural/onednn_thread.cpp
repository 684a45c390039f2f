#include "neural/onednn_thread.h"

#include <dlfcn.h>

namespace drc {
namespace {

// Looked up at run time: which OpenMP library there is, if any, is the choice of whoever built oneDNN, and a second
// one linked here would have its own idea of the number of threads.
template <typename Function>
Function* find(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_DEFAULT, name));
}

int maxThreads() {
    static auto* const get = find<int()>("omp_get_max_threads");
    return get ? get() : 0;
}

void setThreads(int count) {
    static auto* const set = find<void(int)>("omp_set_num_threads");
    if (set && count > 0) set(count);
}

}  // namespace

const dnnl::engine& cpuEngine() {
    static const dnnl::engine engine(dnnl::engine::kind::cpu, 0);
    return engine;
}

SingleThreadScope::SingleThreadScope() : previous_(maxThreads()) {
    if (previous_ > 1) setThreads(1);
}

SingleThreadScope::~SingleThreadScope() {
    if (previous_ > 1) setThreads(previous_);
}

}  // namespace drc
