#include "neural/onednn_thread.h"

#include <dlfcn.h>

namespace drc {
namespace {

// The functions that set OpenMP's number of threads, looked up at run time: whoever built oneDNN chose its OpenMP
// library, if any, and a second one linked to this program would have its own number of threads.
struct OpenMp {
    int (*maxThreads)() = nullptr;
    void (*setThreads)(int) = nullptr;
};

OpenMp openMpOf(void* library) {
    OpenMp found;
    found.maxThreads = reinterpret_cast<int (*)()>(::dlsym(library, "omp_get_max_threads"));
    found.setThreads = reinterpret_cast<void (*)(int)>(::dlsym(library, "omp_set_num_threads"));
    return found.maxThreads && found.setThreads ? found : OpenMp{};
}

// The shared library that contains oneDNN; null if it is linked statically.
void* oneDnnLibrary() {
    Dl_info info = {};
    // By the address of its data, because a function's address may be that of the caller's PLT entry.
    if (::dladdr(::dnnl_version(), &info) == 0 || !info.dli_fname) return nullptr;
    return ::dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
}

// The OpenMP library that oneDNN was linked to. A process may have several OpenMP libraries, each with its own number
// of threads, for instance a Python program that loads PyTorch. oneDNN uses the linked one, unless another was globally
// visible when oneDNN was loaded.
OpenMp linkedOpenMp() {
    void* const library = oneDnnLibrary();
    return library ? openMpOf(library) : OpenMp{};
}

// The globally visible OpenMP library, if it is not the linked one. oneDNN uses it, unless it was loaded after oneDNN.
OpenMp visibleOpenMp() {
    const OpenMp visible = openMpOf(RTLD_DEFAULT);
    return visible.setThreads == linkedOpenMp().setThreads ? OpenMp{} : visible;
}

// One of these is oneDNN's. Limiting the other to one thread for a while does no harm.
const std::array<OpenMp, 2>& openMps() {
    static const std::array<OpenMp, 2> all{linkedOpenMp(), visibleOpenMp()};
    return all;
}

}  // namespace

const dnnl::engine& cpuEngine() {
    static const dnnl::engine engine(dnnl::engine::kind::cpu, 0);
    return engine;
}

SingleThreadScope::SingleThreadScope() {
    for (size_t i = 0; i < previous_.size(); ++i) {
        const OpenMp& openMp = openMps()[i];
        previous_[i] = openMp.maxThreads ? openMp.maxThreads() : 0;
        if (previous_[i] > 1) openMp.setThreads(1);
    }
}

SingleThreadScope::~SingleThreadScope() {
    for (size_t i = 0; i < previous_.size(); ++i)
        if (previous_[i] > 1) openMps()[i].setThreads(previous_[i]);
}

}  // namespace drc
