#include "base/huge_array.h"

#include <sys/mman.h>

#include <new>

namespace drc {

void* allocatePages(size_t bytes) {
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    // Only a hint: the system may have no huge pages.
    madvise(memory, bytes, MADV_HUGEPAGE);
    return memory;
}

void freePages(void* memory, size_t bytes) { munmap(memory, bytes); }

}  // namespace drc
