#include "neural/onednn_thread.h"

#include <dlfcn.h>

namespace drc {
namespace {

// Which OpenMP library there is, if any, is the choice of whoever built oneDNN, and a second one linked here would have
// its own idea of the number of threads: its two functions are looked up at run time.
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

// The shared library that oneDNN is in: null where it is part of the program, or of what calls this.
void* oneDnnLibrary() {
    Dl_info info = {};
    // By its data: the address of a function may be that of the caller's jump to it.
    if (::dladdr(::dnnl_version(), &info) == 0 || !info.dli_fname) return nullptr;
    return ::dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
}

// A process may have several OpenMP libraries, each with its own number of threads: a Python program that loads PyTorch
// has. oneDNN uses the one that it was linked to, unless another was globally visible when oneDNN was loaded.
OpenMp linkedOpenMp() {
    void* const library = oneDnnLibrary();
    return library ? openMpOf(library) : OpenMp{};
}

// The library that is globally visible, if it is not the linked one: oneDNN may use it, or it came later and is not
// oneDNN's.
OpenMp visibleOpenMp() {
    const OpenMp visible = openMpOf(RTLD_DEFAULT);
    return visible.setThreads == linkedOpenMp().setThreads ? OpenMp{} : visible;
}

// One of them is oneDNN's; it does no harm to hold the other to one thread for a while.
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
